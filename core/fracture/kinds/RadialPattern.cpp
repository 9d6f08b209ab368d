#include "core/fracture/kinds/RadialPattern.h"

#include "core/base/math/Power.h"
#include "core/base/math/Trigonometry.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/sampling/PairIndex.h"
#include "core/geometry/polygon/ContainmentIndex.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble {
namespace {

constexpr double kDefaultLayersPerRadius = 3.0;  // in a new layer

bool hasLayers(const RadialPattern& pattern) { return pattern.layers > 1; }

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
    parameter<&RadialPattern::centreHeight>(kCentreHeightParameter),
    parameter<&RadialPattern::axis>({.name = "axis",
                                     .caption = "Axis",
                                     .hint = "Axis through the centre, around which the rings are",
                                     .options = kAxisOptions,
                                     .isSpatial = true}),
    parameter<&RadialPattern::layers>({.name = "layers",
                                       .caption = "Layers",
                                       .hint = "Number of times that the rings are repeated along the axis",
                                       .range = {1.0, kMaxTripleNumber},
                                       .sliderRange = {1.0, 20.0},
                                       .isSpatial = true}),
    parameter<&RadialPattern::layerSpacing>({.name = "layerSpacing",
                                             .caption = "Layer spacing",
                                             .hint = "Distance between layers along the axis",
                                             .quantity = Quantity::Length,
                                             .range = kAboveZero,
                                             .sliderRange = {0.01, 5.0, true},
                                             .usedIf = usedIf<RadialPattern, hasLayers>,
                                             .isSpatial = true}),
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

RadialPattern RadialPattern::defaultsFor(const Box3& bounds) {
    const Vec3 centre = (bounds.min + bounds.max) / 2.0;
    RadialPattern pattern{.centre = Vec2(centre), .radius = bounds.diagonal() / 2.0, .centreHeight = centre.z};
    const double height = bounds.max.z - bounds.min.z;
    if (!(height > 0.0)) return pattern;
    pattern.layerSpacing = pattern.radius / kDefaultLayersPerRadius;
    pattern.layers = 1 + 2 * static_cast<std::uint32_t>(std::floor(height / (2.0 * pattern.layerSpacing)));
    return pattern;
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

Status RadialPattern::applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const {
    if (rings >= kMaxTripleNumber || spokes > kMaxTripleNumber)
        return tooManyNumbers(context, "rings or spokes", std::max(rings + 1, spokes));
    if ((double{1.0} * rings * spokes + 1.0) * layers > static_cast<double>(kMaxSeeds - seeds.size()))
        return tooManySeeds(context);
    const int along = static_cast<int>(axis), first = (along + 1) % 3, second = (along + 2) % 3;
    std::vector<IndexedPlace> places;
    const auto ringAt = [&](double ring) { return radius * power(ring / std::max(rings, 1u), exponent); };
    const auto add = [&](std::uint32_t ring, std::uint32_t spoke, std::uint32_t layer) {
        const std::uint32_t index = tripleIndex(ring, spoke, layer);
        Random random = context.randomOf(index);
        const double varied[] = {random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5};
        const double angle = rotation + kFullTurn * (spoke + variation * varied[0]) / spokes;
        const double distance = ring == 0 ? 0.0 : ringAt(ring + variation * varied[1]);
        const double level = zigzagged(layer) + (layers > 1 ? variation * varied[2] : 0.0);
        Vec3 place(centre, centreHeight);
        place[first] += distance * cosine(angle);
        place[second] += distance * sine(angle);
        place[along] += level * layerSpacing;
        if (context.domain.contains(place)) places.push_back({index, place});
    };
    for (std::uint32_t layer = 0; layer < layers; ++layer) {
        add(0, 0, layer);
        for (const IndexPair pair : pairsBelow(rings, spokes)) {
            if (context.isCancelledAt(pair.second)) return TaskContext::cancelled();
            add(pair.first + 1, pair.second, layer);
        }
    }
    addByIndex(places, context, seeds);
    return success();
}

double RadialPattern::estimatedPiecesIn(const SolidDomain&) const { return estimatedPieces(0.0) * layers; }

}  // namespace rubble
