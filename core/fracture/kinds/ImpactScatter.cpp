#include "core/fracture/kinds/ImpactScatter.h"

#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/layer/OutlineFollowing.h"
#include "core/fracture/sampling/FalloffArea.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace rubble {
namespace {

constexpr double kDefaultImpactFraction = 0.08;  // of the outline's diameter: the radius of a new layer
constexpr double kMaxFalloff = 8.0;

constexpr std::array kImpactScatterParameters{
    parameter<&ImpactScatter::centre>({.name = "centre",
                                       .caption = "Centre",
                                       .hint = "Point of impact; drag it in the canvas",
                                       .quantity = Quantity::Length}),
    parameter<&ImpactScatter::count>(kCountParameter),
    parameter<&ImpactScatter::radius>({.name = "radius",
                                       .caption = "Radius",
                                       .hint = "Seeds are densest within this distance of the centre",
                                       .quantity = Quantity::Length,
                                       .range = kAboveZero,
                                       .sliderRange = {0.005, 2.0, true}}),
    parameter<&ImpactScatter::falloff>({.name = "falloff",
                                        .caption = "Falloff",
                                        .hint = "How fast the density decreases beyond the radius: at 2, to a quarter "
                                                "at twice the distance; 0: constant density",
                                        .range = {0.0, kMaxFalloff},
                                        .sliderRange = {0.0, 6.0}}),
    parameter<&ImpactScatter::centreHeight>(kCentreHeightParameter),
};

}  // namespace

constinit const LayerKind ImpactScatter::kKind{.name = "impact",
                                               .caption = "Impact",
                                               .hint = "Seeds dense around a point of impact",
                                               .icon = "layer-impact",
                                               .summary = "{count|1 seed|%1 seeds}",
                                               .role = LayerRole::Scatters,
                                               .parameters = kImpactScatterParameters,
                                               .isRandom = true,
                                               .fillsOutline = true};

ImpactScatter ImpactScatter::defaultsFor(const Box3& bounds) {
    const Vec3 centre = (bounds.min + bounds.max) / 2.0;
    return ImpactScatter{
        .centre = Vec2(centre), .radius = kDefaultImpactFraction * bounds.diagonal(), .centreHeight = centre.z};
}

SeedDensity ImpactScatter::density(const Polygon&) const {
    return [falloff = Falloff{centre, radius, falloff}](Vec2 point) {
        return falloff.at(glm::distance(point, falloff.centre));
    };
}

Status ImpactScatter::apply(const LayerContext& context, SeedSet& seeds) const {
    const Result<std::uint32_t> wanted = seedsToAdd(count, context.scatterOutline(), context, seeds);
    if (!wanted) return wanted.error();
    const Result<FalloffArea> area = FalloffArea::of(context.scatterOutline(), {centre, radius, falloff}, context.task);
    if (!area) return area.error();
    const std::size_t first = seeds.size();
    if (const Status done = scatter(*wanted, *area, context, seeds); !done) return done;
    return followOutline(context, first, ScatterDomain::Outline, seeds, {.density = density(context.outline)});
}

Status ImpactScatter::applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const {
    const Result<std::uint32_t> wanted = seedsToAdd(count, context.domain.volume(), context, seeds);
    if (!wanted) return wanted.error();
    const Vec3 from(centre, centreHeight);
    const double minRadius = Falloff::kMinRadiusFraction * context.domain.bounds().diagonal();
    const Falloff decrease{centre, std::max(radius, minRadius), falloff};
    const SolidDensity density{
        [decrease, from](Vec3 point) { return decrease.at(glm::distance(point, from)); },
        [decrease, from](const Box3& box) {
            return decrease.at(glm::length(glm::max(glm::max(box.min - from, from - box.max), Vec3(0.0))));
        }};
    const Result<SolidScatter> area = SolidScatter::of(context.domain.surface(), density, context.task);
    if (!area) return area.error();
    if (area->isEmpty()) return scatter(*wanted, context.domain, context, seeds);  // so far that it is constant
    return scatter(*wanted, *area, context, seeds);
}

double ImpactScatter::estimatedPiecesIn(const SolidDomain& domain) const {
    return count.in(domain.volume(), SeedSpace::Solid);
}

}  // namespace rubble
