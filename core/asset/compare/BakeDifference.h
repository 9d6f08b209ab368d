#pragma once

#include "core/asset/bake/Bake.h"

#include <vector>

namespace rubble {

/// The difference of a fragment, identified by its path, between two bakes of an asset.
enum class FragmentChange {
    Gone,      // only in the earlier bake
    Added,     // only in the later bake
    Moved,     // its centre of mass moved
    Reshaped,  // in place, but with another volume or inertia
};
inline constexpr int kFragmentChanges = 4;

/// The smallest differences that count as changes: above the rounding errors caused by a different insertion order of
/// the seeds.
struct DifferenceLimits {
    double shift = 1e-6;     // of a centre of mass, relative to the diagonal of the larger outline
    double relative = 1e-6;  // of volume or inertia
    bool operator==(const DifferenceLimits&) const = default;
};

/// One changed fragment.
struct FragmentDifference {
    FragmentPath path;
    FragmentChange change = FragmentChange::Moved;
    std::uint32_t level = 0;
    std::uint32_t before = kNone;  // its number in the earlier bake
    std::uint32_t after = kNone;   // its number in the later bake
    double shift = 0.0;            // m, of its centre of mass
    double volumeBefore = 0.0;     // m³; 0 if it is missing
    double volumeAfter = 0.0;
};

/// The numbers of fragments and changes of one level.
struct LevelDifference {
    std::size_t before = 0;
    std::size_t after = 0;
    std::size_t changed[kFragmentChanges] = {};  // one per FragmentChange
    std::size_t unchanged = 0;
    bool operator==(const LevelDifference&) const = default;
};

/// The differences between two bakes of an asset.
struct BakeDifference {
    std::vector<FragmentDifference>
        fragments;                        // by FragmentChange, then by number in the earlier bake, else the later one
    std::vector<LevelDifference> levels;  // from 0; as many as the deeper bake has

    bool isEmpty() const { return fragments.empty(); }
    std::size_t count(FragmentChange change) const;
    /// The sums over all levels.
    LevelDifference sum() const;
};

/// Compares two bakes by the paths of their fragments, ignoring the asset's id. O(n log n) in the fragments.
BakeDifference differenceOf(const Bake& before, const Bake& after, const DifferenceLimits& limits = {});

}  // namespace rubble
