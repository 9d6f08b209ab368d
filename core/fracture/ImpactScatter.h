#pragma once

#include "core/fracture/PatternKindForward.h"
#include "core/fracture/SeedCount.h"
#include "core/geometry/Vec.h"

namespace rubble {

/// `count` seeds, dense about a point of impact and fewer the farther from it: at a distance d their density goes with
/// (1 + (d/radius)²)^(-falloff/2), about even within the radius and falling with d^-falloff beyond it. The first n of a greater
/// count are the same n.
///
/// Source: the thesis, 3.3, which asks for such seeds and leaves their law open.
struct ImpactScatter {
    Vec2 centre{0.0, 0.0};  // m; may lie outside the outline
    SeedCount count = 60;
    double radius = 0.1;   // m
    double falloff = 2.5;  // 0: the same density everywhere

    bool operator==(const ImpactScatter&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    static const PatternKind kKind;
};

}  // namespace rubble
