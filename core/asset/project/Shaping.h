#pragma once

#include "core/asset/project/FragmentPath.h"
#include "core/fracture/pieces/PieceSplit.h"
#include "core/fracture/pieces/SmallPieces.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rubble {

/// Displacement of cut edges in render and export meshes, by noise that vanishes where edges meet. Collision hulls,
/// masses and bonds ignore it.
struct Roughness {
    static constexpr std::uint32_t kMaxOctaves = 8;
    double amplitude = 0.0;        // m, >= 0; 0: straight cuts
    double frequency = 10.0;       // 1/m, > 0: bumps per metre
    std::uint32_t octaves = 3;     // 1 to kMaxOctaves; each has half the amplitude and twice the frequency of the last
    std::uint64_t randomSeed = 0;  // shown to the artist
    bool operator==(const Roughness&) const = default;
};

/// Changes to the pieces of a pattern, on all levels.
struct Shaping {
    SmallPieces smallPieces;
    double gap = 0.0;  // m between pieces, >= 0
    Roughness roughness;
    bool operator==(const Shaping&) const = default;
};

/// Sibling fragments merged into one, which keeps the name of the first.
struct FragmentMerge {
    FragmentPath into;
    std::vector<FragmentPath> merged;
    bool operator==(const FragmentMerge&) const = default;
};
/// A fragment split along a line, in the xy plane of the asset; one of a mesh along the plane through it along z. Its
/// parts take the next free numbers of their cell.
struct FragmentSplit {
    FragmentPath fragment;
    Line line;
    bool operator==(const FragmentSplit&) const = default;
};
using FragmentEdit = std::variant<FragmentMerge, FragmentSplit>;

/// The parent of the fragments that an edit changes; empty: the whole.
FragmentPath parentOf(const FragmentEdit& edit);

/// The first fault as a sentence, or nothing.
std::optional<std::string> verifyShaping(const Shaping& shaping);
std::optional<std::string> verifyEdit(const FragmentEdit& edit);

}  // namespace rubble
