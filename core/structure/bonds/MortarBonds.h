#pragma once

#include "core/structure/bonds/Bond.h"
#include "core/structure/bonds/FaceContact.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A fragment among those of several bodies, all in one frame.
struct MortarNode {
    std::uint32_t body = 0;       // fragments of the same body are not joined
    Vec3 centre{0.0};             // m: its centre of mass
    std::vector<Polytope> hulls;  // that fill it
};

/// Faces that touch are this far apart at most for the rounding of their coordinates, m: of rotated ones at 100 km, and
/// of files with six decimals. It is added to all tolerances below.
inline constexpr double kFaceRounding = 1e-6;

/// The bonds between fragments of different bodies whose faces lie against each other, see faceContact(): those of all
/// their hulls are one bond. By first, then second. Pairs of less than `leastArea` (m²) are not joined.
/// O(n log n) in the hulls, and their contacts.
///
/// `budget`: how many hulls and pairs of them may still be looked at, reduced by those that were; at 0 the result is
/// incomplete.
std::vector<Bond> mortarBonds(std::span<const MortarNode> nodes, double tolerance, double leastArea,
                              std::size_t* budget = nullptr);

/// The bonds of fragments to anchors, where they lie against solids that hold them: one per fragment,
/// ascending. `budget` as for mortarBonds().
std::vector<Bond> anchorBonds(std::span<const MortarNode> nodes, std::span<const Polytope> supports, double tolerance,
                              double leastArea);

}  // namespace rubble
