#include "core/fracture/FalloffArea.h"
#include "core/fracture/PatternKind.h"

namespace rubble {
namespace {

constexpr double kUsualShare = 0.08;  // of the outline's diameter: the radius of a new layer
constexpr double kMostFalloff = 8.0;

constexpr std::array kParameters{
    parameter<&ImpactScatter::centre>({.name = "centre",
                                       .caption = "Centre",
                                       .hint = "Where the asset is hit; it can be dragged in the canvas",
                                       .quantity = Quantity::Length}),
    parameter<&ImpactScatter::count>(kCountParameter),
    parameter<&ImpactScatter::radius>({.name = "radius",
                                       .caption = "Radius",
                                       .hint = "Within this distance of the centre seeds are densest",
                                       .quantity = Quantity::Length,
                                       .range = kAboveZero,
                                       .usual = {0.005, 2.0, true}}),
    parameter<&ImpactScatter::falloff>({.name = "falloff",
                                        .caption = "Falloff",
                                        .hint = "How fast seeds become fewer beyond the radius: at 2, a quarter of "
                                                "them at twice the distance; 0: not at all",
                                        .range = {0.0, kMostFalloff},
                                        .usual = {0.0, 6.0}}),
};

}  // namespace

constinit const PatternKind ImpactScatter::kKind{.name = "impact",
                                                 .caption = "Impact",
                                                 .hint = "Seeds dense about a point, and fewer the farther from it",
                                                 .role = LayerRole::Scatters,
                                                 .parameters = kParameters,
                                                 .suitedTo = [](const Box2& bounds) -> LayerParameters {
                                                     return ImpactScatter{.centre = (bounds.min + bounds.max) / 2.0,
                                                                          .radius = kUsualShare * bounds.diagonal()};
                                                 }};

Status ImpactScatter::apply(const LayerContext& context, SeedSet& seeds) const {
    const Result<std::uint32_t> wanted = seedsToAdd(count, context.outline, context, seeds);
    if (!wanted) return wanted.error();
    const Result<FalloffArea> area = FalloffArea::of(context.outline, {centre, radius, falloff}, context.task);
    if (!area) return area.error();
    return scatter(*wanted, *area, context, seeds);
}

}  // namespace rubble
