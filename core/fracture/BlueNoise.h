#pragma once

#include "core/fracture/PatternKindForward.h"
#include "core/fracture/ScatterDomain.h"
#include "core/fracture/SeedCount.h"

namespace rubble {

/// Random seeds of which no two are nearer than `minimumDistance`; `count` of them, or as many as find room.
/// Earlier seeds are the same at a greater count.
struct BlueNoise {
    double minimumDistance = 0.1;  // m
    SeedCount count = 0;           // the number 0: as many as find room
    ScatterDomain domain = ScatterDomain::Outline;

    bool operator==(const BlueNoise&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    static const PatternKind kKind;
};

}  // namespace rubble
