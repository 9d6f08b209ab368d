#pragma once

#include "core/fracture/layer/LayerForward.h"
#include "core/fracture/layer/SeedDensity.h"
#include "core/fracture/sampling/GreyImage.h"
#include "core/fracture/sampling/SeedCount.h"

#include <memory>

namespace rubble {

/// `count` seeds distributed by an image that is stretched over the outline's bounding box: their density at a pixel is
/// proportional to its brightness, or darkness, times its opacity. Increasing the count keeps existing seeds. No seeds
/// without an image.
struct DensityImage {
    SeedCount count = 200;
    DenseWhere dense = DenseWhere::Dark;
    std::shared_ptr<const GreyImage> image;  // null: none selected yet

    bool operator==(const DensityImage& other) const;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    Status applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const;
    std::optional<std::string> fault() const;
    SeedDensity density(const Polygon& outline) const;  // null without an image
    double estimatedPieces(double area) const { return count.in(area); }
    double estimatedPiecesIn(const SolidDomain& domain) const;
    static const LayerKind kKind;
    const char* summary() const;
};

}  // namespace rubble
