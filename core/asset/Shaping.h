#pragma once

#include "core/asset/FragmentPath.h"
#include "core/fracture/PieceDraft.h"
#include "core/fracture/SmallPieces.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rubble {

/// How far cut edges are displaced where pieces are drawn and exported, by noise that vanishes where edges meet. Hulls, masses
/// and bonds know nothing of it.
struct Roughness {
    static constexpr std::uint32_t kMostOctaves = 8;
    double amplitude = 0.0;        // m, >= 0; 0: cuts are straight
    double frequency = 10.0;       // bumps a metre, > 0
    std::uint32_t octaves = 3;     // from 1: each half as high and twice as fine as the one before
    std::uint64_t randomSeed = 0;  // shown to the artist
    bool operator==(const Roughness&) const = default;
};

/// What is done to the pieces that a pattern gives, on all levels.
struct Shaping {
    SmallPieces smallPieces;
    double gap = 0.0;  // m between pieces, >= 0
    Roughness roughness;
    bool operator==(const Shaping&) const = default;
};

/// Fragments of one breaking that are one: the first keeps its name.
struct FragmentMerge {
    FragmentPath into;
    std::vector<FragmentPath> merged;
    bool operator==(const FragmentMerge&) const = default;
};
/// A fragment cut along a line, in the prism's coordinates. Its parts are named by the free numbers of their cell.
struct FragmentSplit {
    FragmentPath fragment;
    Line line;
    bool operator==(const FragmentSplit&) const = default;
};
using FragmentEdit = std::variant<FragmentMerge, FragmentSplit>;

/// The fragment whose breaking an edit changes pieces of; empty: the whole.
FragmentPath placeOf(const FragmentEdit& edit);

/// Says in one sentence what is wrong, or nothing where all is well.
std::optional<std::string> verifyShaping(const Shaping& shaping);
std::optional<std::string> verifyEdit(const FragmentEdit& edit);

/// Merges and splits pieces of one breaking, whose frame stands at `offset` in the prism's: edits with another place than
/// `place` are passed over. LostPiece is reported where a piece is not there, does not touch the others, or is missed by its line.
Partition editedPieces(Partition partition, const Seeds& seeds, const std::vector<FragmentEdit>& edits,
                       const FragmentPath& place, Vec2 offset);

}  // namespace rubble
