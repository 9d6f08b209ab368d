#include "core/base/Power.h"
#include "core/base/Trigonometry.h"
#include "core/fracture/PairIndex.h"
#include "core/fracture/PatternKind.h"

#include <algorithm>
#include <numbers>

namespace rubble {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;

constexpr std::array kParameters{
    parameter<&RadialPattern::centre>({.name = "centre",
                                       .caption = "Centre",
                                       .hint = "Where the rings have their middle; it can be dragged in the canvas",
                                       .quantity = Quantity::Length}),
    parameter<&RadialPattern::radius>({.name = "radius",
                                       .caption = "Radius",
                                       .hint = "How far from the centre the outermost ring is",
                                       .quantity = Quantity::Length,
                                       .range = kAboveZero,
                                       .usual = {0.01, 5.0, true}}),
    parameter<&RadialPattern::rings>({.name = "rings",
                                      .caption = "Rings",
                                      .hint = "How many rings of seeds there are around the one in the centre",
                                      .range = {0.0, kMostOfPair},
                                      .usual = {0.0, 30.0}}),
    parameter<&RadialPattern::spokes>({.name = "spokes",
                                       .caption = "Spokes",
                                       .hint = "How many seeds each ring has",
                                       .range = {1.0, kMostOfPair},
                                       .usual = {1.0, 60.0}}),
    parameter<&RadialPattern::exponent>(
        {.name = "exponent",
         .caption = "Ring spacing",
         .hint = "1: rings at equal distances; above: closer together towards the centre; below: towards the rim",
         .range = {0.1, 10.0},
         .usual = {0.25, 4.0, true}}),
    parameter<&RadialPattern::turn>({.name = "turn",
                                     .caption = "Turn",
                                     .hint = "By how much all spokes are turned about the centre",
                                     .quantity = Quantity::Angle,
                                     .range = {-kFullTurn, kFullTurn},
                                     .usual = {-std::numbers::pi, std::numbers::pi}}),
    parameter<&RadialPattern::variation>(
        {.name = "variation",
         .caption = "Variation",
         .hint = "0: seeds exactly on rings and spokes; 1: up to half way to their neighbours",
         .range = {0.0, 1.0},
         .usual = {0.0, 1.0}}),
};

}  // namespace

constinit const PatternKind RadialPattern::kKind{.name = "radial",
                                                 .caption = "Radial",
                                                 .hint = "Seeds on rings about a centre, as glass cracks around a hole",
                                                 .role = LayerRole::Scatters,
                                                 .parameters = kParameters,
                                                 .suitedTo = [](const Box2& bounds) -> LayerParameters {
                                                     return RadialPattern{.centre = (bounds.min + bounds.max) / 2.0,
                                                                          .radius = bounds.diagonal() / 2.0};
                                                 }};

Status RadialPattern::apply(const LayerContext& context, SeedSet& seeds) const {
    if (std::size_t{rings} * spokes + 1 > kMostSeeds - seeds.size()) return tooManySeeds(context);
    const auto add = [&](std::uint32_t index, Vec2 position) {
        if (containment(context.outline, position) != Containment::Outside)
            seeds.add({context.layer.id, index}, position, false);
    };
    const auto ringAt = [&](double ring) { return radius * power(ring / rings, exponent); };
    add(0, centre);
    std::size_t round = 0;
    for (const IndexPair pair : pairsBelow(rings, spokes)) {
        if (context.isCancelledAt(round++)) return TaskContext::cancelled();
        Random random = context.randomOf(pair.index());
        const double ring = pair.first + 1 + variation * (random.unit() - 0.5);
        const double spoke = pair.second + variation * (random.unit() - 0.5);
        const double angle = turn + kFullTurn * spoke / spokes;
        add(pair.index() + 1, centre + ringAt(ring) * Vec2(cosine(angle), sine(angle)));
    }
    return success();
}

}  // namespace rubble
