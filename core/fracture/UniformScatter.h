#pragma once

#include "core/fracture/PatternKindForward.h"
#include "core/fracture/ScatterDomain.h"
#include "core/fracture/SeedCount.h"

namespace rubble {

/// `count` seeds, uniformly at random. The first n of a greater count are the same n.
struct UniformScatter {
    SeedCount count = 20;
    ScatterDomain domain = ScatterDomain::Outline;

    bool operator==(const UniformScatter&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    static const PatternKind kKind;
};

}  // namespace rubble
