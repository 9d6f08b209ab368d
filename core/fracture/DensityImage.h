#pragma once

#include "core/fracture/GreyImage.h"
#include "core/fracture/PatternKindForward.h"
#include "core/fracture/SeedCount.h"

#include <memory>

namespace rubble {

enum class DenseWhere { Bright, Dark };

/// `count` seeds that follow a picture which is stretched over the outline's bounding box: their density at a pixel goes with its
/// brightness, or its darkness, times its opacity. The first n of a greater count are the same n. No seeds without a picture.
struct DensityImage {
    SeedCount count = 200;
    DenseWhere dense = DenseWhere::Dark;
    std::shared_ptr<const GreyImage> image;  // null: none was chosen yet

    bool operator==(const DensityImage& other) const;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    std::optional<std::string> fault() const;
    static const PatternKind kKind;
};

}  // namespace rubble
