#include "core/fracture/kinds/DensityImage.h"

#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/layer/OutlineFollowing.h"
#include "core/fracture/sampling/DensityArea.h"

namespace rubble {
namespace {

constexpr std::array<ParameterOption, 2> kDense{{{"bright", "Bright areas"}, {"dark", "Dark areas"}}};

constexpr std::array kDensityImageParameters{
    parameter<&DensityImage::count>(kCountParameter),
    parameter<&DensityImage::dense>({.name = "dense",
                                     .caption = "Dense",
                                     .hint = "Where seeds are densest; transparent areas have none",
                                     .options = kDense}),
};

/// The density of an image that is stretched over a box in the xy plane, the same along z.
SolidDensity densityAlongZ(const DensityImage& layer, const Box3& box) {
    const Vec2 min(box.min), size = Vec2(box.max) - min;
    const auto at = [image = layer.image, dense = layer.dense, min, size](Vec3 point) {
        return densityAt(*image, dense, (Vec2(point) - min) / size);
    };
    const auto maxIn = [image = layer.image, dense = layer.dense, min, size](const Box3& part) {
        return maxDensityIn(*image, dense, (Vec2(part.min) - min) / size, (Vec2(part.max) - min) / size);
    };
    return {at, maxIn};
}

Diagnostic noDensity(DenseWhere dense, const EvaluatedLayer& context, std::uint32_t wanted) {
    const std::string where = dense == DenseWhere::Bright ? "black" : "white";
    return diagnostic(DiagnosticCode::NoRoom, {.layer = context.layerId},
                      context.name() + " found room for 0 of " + std::to_string(wanted) + " seeds: its image is " +
                          where + " or transparent everywhere in the outline.");
}

}  // namespace

constinit const LayerKind DensityImage::kKind{.name = "densityImage",
                                              .caption = "Density image",
                                              .hint = "Seeds distributed by a grey-scale image",
                                              .icon = "layer-density-image",
                                              .role = LayerRole::Scatters,
                                              .parameters = kDensityImageParameters,
                                              .isRandom = true,
                                              .fillsOutline = true};

const char* DensityImage::summary() const { return image ? "{count|1 seed|%1 seeds}" : "no picture"; }

bool DensityImage::operator==(const DensityImage& other) const {
    const bool isSame = image == other.image || (image && other.image && *image == *other.image);
    return isSame && count == other.count && dense == other.dense;
}

std::optional<std::string> DensityImage::fault() const { return image ? verifyGreyImage(*image) : std::nullopt; }

SeedDensity DensityImage::density(const Polygon& outline) const {
    if (!image) return nullptr;
    return [image = image, dense = dense, box = boundsOf(outline.outer)](Vec2 point) {
        return densityAt(*image, dense, (point - box.min) / box.size());
    };
}

Status DensityImage::apply(const LayerContext& context, SeedSet& seeds) const {
    if (!image) return success();
    const Result<std::uint32_t> wanted = seedsToAdd(count, context.scatterOutline(), context, seeds);
    if (!wanted) return wanted.error();
    const Result<DensityArea> area = DensityArea::of(context.scatterOutline(), *image, dense, context.task);
    if (!area) return area.error();
    if (area->isEmpty()) {
        if (*wanted > 0) seeds.diagnostics.push_back(noDensity(dense, context, *wanted));
        return success();
    }
    const std::size_t first = seeds.size();
    if (const Status done = scatter(*wanted, *area, context, seeds); !done) return done;
    return followOutline(context, first, ScatterDomain::Outline, seeds, {.density = density(context.scatterOutline())});
}

Status DensityImage::applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const {
    if (!image) return success();
    const Result<std::uint32_t> wanted = seedsToAdd(count, context.domain.volume(), context, seeds);
    if (!wanted) return wanted.error();
    const Result<SolidScatter> area =
        SolidScatter::of(context.domain.surface(), densityAlongZ(*this, context.domain.bounds()), context.task);
    if (!area) return area.error();
    if (area->isEmpty()) {
        if (*wanted > 0) seeds.diagnostics.push_back(noDensity(dense, context, *wanted));
        return success();
    }
    return scatter(*wanted, *area, context, seeds);
}

double DensityImage::estimatedPiecesIn(const SolidDomain& domain) const {
    return count.in(domain.volume(), SeedSpace::Solid);
}

}  // namespace rubble
