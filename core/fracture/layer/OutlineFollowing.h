#pragma once

#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/sampling/ScatterDomain.h"

namespace rubble {

/// The first index of seeds that followOutline() adds: above those that a layer scatters itself.
inline constexpr std::uint32_t kFirstAddedSeed = kMaxSeeds;

/// How seeds are added where the outline grew.
struct AddedSeeds {
    double minimumDistance = 0.0;   // m, between seeds of the layer
    SeedDensity density = nullptr;  // null: constant
};

/// Makes the seeds of a layer, which start at `first` and were scattered in context.scatterOutline(), fit the present
/// outline: removes those outside its domain, unless they were moved by hand, and adds seeds with the same mean density
/// where it grew. A seed that is added depends on its tile of a fixed grid, not on the rest of the outline. Without an
/// earlier outline, nothing is done.
///
/// Errors: Limit if there would be too many seeds; Cancelled.
Status followOutline(const LayerContext& context, std::size_t first, ScatterDomain domain, SeedSet& seeds,
                     const AddedSeeds& added = {});

}  // namespace rubble
