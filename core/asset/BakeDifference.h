#pragma once

#include "core/asset/Bake.h"

#include <vector>

namespace rubble {

/// What became of a fragment, found by its path, between two bakes of an asset.
enum class PieceChange {
    Gone,      // there is none of that name any more
    Added,     // there was none of that name before
    Moved,     // its centre of mass is elsewhere
    Reshaped,  // where it was, but of another volume or otherwise spread
};
inline constexpr int kPieceChanges = 4;

/// From where on fragments count as changed. Smaller differences are what rounding leaves when seeds are inserted in another
/// order.
struct DifferenceLimits {
    double shift = 1e-6;  // of the diagonal of the greater outline, that a centre of mass moved
    double share = 1e-6;  // of volume or inertia
    bool operator==(const DifferenceLimits&) const = default;
};

/// One fragment that is not as it was.
struct PieceDifference {
    FragmentPath path;
    PieceChange change = PieceChange::Moved;
    std::uint32_t level = 0;
    std::uint32_t before = kNone;  // its number in the earlier bake
    std::uint32_t after = kNone;   // and in the later one
    double shift = 0.0;            // m that its centre of mass moved
    double volumeBefore = 0.0;     // m^3; 0 where it is not there
    double volumeAfter = 0.0;
};

/// How many fragments of one level there are, and what became of them.
struct LevelDifference {
    std::size_t before = 0;
    std::size_t after = 0;
    std::size_t changed[kPieceChanges] = {};  // one a PieceChange
    std::size_t unchanged = 0;
    bool operator==(const LevelDifference&) const = default;
};

/// Two bakes of an asset, fragment by fragment.
struct BakeDifference {
    std::vector<PieceDifference>
        pieces;  // as PieceChange is ordered, then by number in the earlier bake, or in the later one
    std::vector<LevelDifference> levels;  // from 0; as many as the deeper bake has

    bool isNone() const { return pieces.empty(); }
    std::size_t count(PieceChange change) const;
    /// Of all levels together.
    LevelDifference sum() const;
};

/// Compares two bakes by the paths of their fragments, whatever the asset's id. O(n log n) of the fragments.
BakeDifference differenceOf(const Bake& before, const Bake& after, const DifferenceLimits& limits = {});

}  // namespace rubble
