#pragma once

#include "core/fracture/PatternKindForward.h"

namespace rubble {

/// Moves the scattered seeds of the layers before it to the centres of their cells, `rounds` times. Seeds placed
/// by hand or moved by an override stay where they are.
struct LloydRelaxation {
    std::uint32_t rounds = 3;

    bool operator==(const LloydRelaxation&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    static const PatternKind kKind;
};

}  // namespace rubble
