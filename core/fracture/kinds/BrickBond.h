#pragma once

#include "core/fracture/layer/LayerForward.h"
#include "core/geometry/predicates/Vec.h"

namespace rubble {

/// The overlap of the bricks of successive courses.
enum class BondKind {
    Stretcher,  // long sides, each course shifted by half a brick
    Stack,      // long sides above each other
    English,    // courses of long sides and of short sides alternate
    Header,     // short sides, each course shifted by half of one
    Flemish,    // long and short sides alternate, a short one over the middle of each long one
};

/// A brick wall. The cuts run along the centre lines of the joints: a cell is a brick with half the mortar around it,
/// so that the bond repeats after a brick and a joint. Cells are named by column and course, counted outwards from the
/// origin (see BrickCourses), and keep their names when the outline changes.
struct BrickBond {
    BondKind bond = BondKind::Stretcher;
    double length = 0.24;   // m, of the long side; all three without mortar
    double width = 0.115;   // m, of the short side
    double height = 0.071;  // m
    double mortar = 0.01;   // m
    Vec2 origin{0.0, 0.0};  // m: the lower left corner of course 0

    // In a closed mesh: seeds in the middles of bricks, whose courses lie above each other along y.
    double depth = 0.115;       // m, of a brick along z, without mortar
    double originHeight = 0.0;  // z of the origin, m

    bool operator==(const BrickBond&) const = default;
    Status cut(const LayerContext& context, CutSet& cuts) const;
    Status applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const;
    double estimatedPieces(double area) const;
    double estimatedPiecesIn(const SolidDomain& domain) const;
    static const LayerKind kKind;
    const char* summary() const;
    static BrickBond defaultsFor(const Box3& bounds);
};

}  // namespace rubble
