#include "core/fracture/kinds/ImpactScatter.h"

#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/layer/OutlineFollowing.h"
#include "core/fracture/sampling/FalloffArea.h"

#include <glm/geometric.hpp>

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

ImpactScatter ImpactScatter::defaultsFor(const Box2& bounds) {
    return ImpactScatter{.centre = (bounds.min + bounds.max) / 2.0,
                         .radius = kDefaultImpactFraction * bounds.diagonal()};
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

}  // namespace rubble
