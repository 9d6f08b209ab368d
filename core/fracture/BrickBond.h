#pragma once

#include "core/fracture/PatternKindForward.h"
#include "core/geometry/Vec.h"

namespace rubble {

enum class BondKind {
    Stretcher,  // long sides, each course half a brick along
    Stack,      // long sides above each other
    English,    // courses of long sides and of short ones in turns
    Header,     // short sides, each course half of one along
    Flemish,    // long and short sides in turns, a short one over the middle of each long one
};

/// A wall of bricks. What is cut are the middles of its joints: a brick with half the mortar around it is a cell, so that the bond
/// repeats after a brick and a joint. Cells are called by column and course, counted from the origin outwards (see BrickCourses),
/// and keep their names whatever the outline is.
struct BrickBond {
    BondKind bond = BondKind::Stretcher;
    double length = 0.24;   // m, of the long side; these three without mortar
    double width = 0.115;   // m, of the short side
    double height = 0.071;  // m
    double mortar = 0.01;   // m
    Vec2 origin{0.0, 0.0};  // m: where course 0 begins, at the bottom and on the left

    bool operator==(const BrickBond&) const = default;
    Status cut(const LayerContext& context, CutSet& cuts) const;
    static const PatternKind kKind;
};

}  // namespace rubble
