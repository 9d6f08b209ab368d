#include "core/fracture/kinds/RadialPattern.h"

#include "core/base/math/Power.h"
#include "core/base/math/Trigonometry.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/sampling/PairIndex.h"
#include "core/geometry/polygon/ContainmentIndex.h"

#include <algorithm>
#include <numbers>

namespace rubble {
namespace {

constexpr std::array kRadialPatternParameters{
    parameter<&RadialPattern::centre>({.name = "centre",
                                       .caption = "Centre",
                                       .hint = "Centre of the rings; drag it in the canvas",
                                       .quantity = Quantity::Length}),
    parameter<&RadialPattern::radius>({.name = "radius",
                                       .caption = "Radius",
                                       .hint = "Radius of the outermost ring",
                                       .quantity = Quantity::Length,
                                       .range = kAboveZero,
                                       .sliderRange = {0.01, 5.0, true}}),
    parameter<&RadialPattern::rings>({.name = "rings",
                                      .caption = "Rings",
                                      .hint = "Number of rings around the centre",
                                      .range = {0.0, kMaxPairNumber},
                                      .sliderRange = {0.0, 30.0}}),
    parameter<&RadialPattern::spokes>({.name = "spokes",
                                       .caption = "Spokes",
                                       .hint = "Number of seeds on each ring",
                                       .range = {1.0, kMaxPairNumber},
                                       .sliderRange = {1.0, 60.0}}),
    parameter<&RadialPattern::exponent>(kRingSpacingParameter),
    parameter<&RadialPattern::rotation>({.name = "turn",
                                         .caption = "Rotation",
                                         .hint = "Rotation of all spokes about the centre",
                                         .quantity = Quantity::Angle,
                                         .range = {-kFullTurn, kFullTurn},
                                         .sliderRange = {-std::numbers::pi, std::numbers::pi}}),
    parameter<&RadialPattern::variation>(
        {.name = "variation",
         .caption = "Variation",
         .hint = "0: seeds exactly on rings and spokes; 1: up to halfway to their neighbours",
         .range = {0.0, 1.0},
         .sliderRange = {0.0, 1.0}}),
};

}  // namespace

constinit const LayerKind RadialPattern::kKind{.name = "radial",
                                               .caption = "Radial",
                                               .hint = "Seeds on concentric rings, like cracks in glass around a hole",
                                               .icon = "layer-radial",
                                               .summary = "{rings|1 ring|%1 rings} of {spokes}",
                                               .role = LayerRole::Scatters,
                                               .parameters = kRadialPatternParameters,
                                               .isRandom = true};

RadialPattern RadialPattern::defaultsFor(const Box2& bounds) {
    return RadialPattern{.centre = (bounds.min + bounds.max) / 2.0, .radius = bounds.diagonal() / 2.0};
}

Status RadialPattern::apply(const LayerContext& context, SeedSet& seeds) const {
    if (std::size_t{rings} * spokes + 1 > kMaxSeeds - seeds.size()) return tooManySeeds(context);
    const ContainmentIndex outline(context.outline);
    const auto add = [&](std::uint32_t index, Vec2 position) {
        if (outline.of(position) != Containment::Outside) seeds.add({context.layerId, index}, position, false);
    };
    const auto ringAt = [&](double ring) { return radius * power(ring / rings, exponent); };
    add(0, centre);
    std::size_t round = 0;
    for (const IndexPair pair : pairsBelow(rings, spokes)) {
        if (context.isCancelledAt(round++)) return TaskContext::cancelled();
        Random random = context.randomOf(pair.index());
        const double ring = pair.first + 1 + variation * (random.unit() - 0.5);
        const double spoke = pair.second + variation * (random.unit() - 0.5);
        const double angle = rotation + kFullTurn * spoke / spokes;
        add(pair.index() + 1, centre + ringAt(ring) * Vec2(cosine(angle), sine(angle)));
    }
    return success();
}

}  // namespace rubble
