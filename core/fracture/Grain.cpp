#include "core/fracture/Grain.h"

#include "core/base/Trigonometry.h"
#include "core/fracture/Partition.h"
#include "core/fracture/PatternKind.h"
#include "core/geometry/PointFrame.h"

#include <algorithm>
#include <numbers>

namespace rubble {
namespace {

constexpr double kMostRatio = 20.0;  // more takes digits from where points of the outline's edges come to lie

constexpr std::array kParameters{
    parameter<&Grain::angle>({.name = "angle",
                              .caption = "Angle",
                              .hint = "How the grain runs: 0 is level",
                              .quantity = Quantity::Angle,
                              .range = {-kLargestAngle, kLargestAngle},
                              .usual = {-std::numbers::pi, std::numbers::pi}}),
    parameter<&Grain::ratio>({.name = "ratio",
                              .caption = "Ratio",
                              .hint = "How many times as long as wide pieces are on average",
                              .range = {1.0, kMostRatio},
                              .usual = {1.0, 10.0}}),
};

/// Where the outline's corners have come to, and where they were.
using CornerPairs = std::vector<std::pair<std::array<double, 2>, Vec2>>;

void addCorners(const Ring& mapped, const Ring& ring, Vec2 mappedOrigin, Vec2 origin, CornerPairs& pairs) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 place = mapped[k] - mappedOrigin;
        pairs.push_back({{place.x, place.y}, ring[k] - origin});
    }
}

}  // namespace

constinit const PatternKind Grain::kKind{.name = "grain",
                                         .caption = "Grain",
                                         .hint = "Makes the cells of all seeds long in one direction",
                                         .role = LayerRole::Measures,
                                         .parameters = kParameters,
                                         .suitedTo = [](const Box2&) -> LayerParameters { return Grain{}; }};

std::optional<GrainMap> GrainMap::of(const Pattern& pattern, const Polygon& outline) {
    std::optional<GrainMap> all;
    for (const PatternLayer& layer : pattern.layers) {
        const auto* grain = std::get_if<Grain>(&layer.parameters);
        if (!grain || !layer.isOn || grain->ratio == 1.0) continue;
        const Vec2 along(cosine(grain->angle), sine(grain->angle)), across = perpendicular(along);
        GrainMap map;
        map.m_origin = frameOf(outline).origin;
        for (const std::size_t axis : {0u, 1u}) {
            const auto part = static_cast<int>(axis);
            map.m_there[axis] = along * (along[part] / grain->ratio) + across * across[part];
            map.m_back[axis] = along * (along[part] * grain->ratio) + across * across[part];
        }
        if (all) {
            map.m_there = {map.there(all->m_there[0]), map.there(all->m_there[1])};
            map.m_back = {all->back(map.m_back[0]), all->back(map.m_back[1])};
        }
        all = map;
    }
    return all;
}

std::vector<Vec2> GrainMap::operator()(std::span<const Vec2> points) const {
    std::vector<Vec2> mapped;
    mapped.reserve(points.size());
    for (const Vec2 point : points) mapped.push_back((*this)(point));
    return mapped;
}

Polygon GrainMap::operator()(Polygon polygon) const {
    polygon.outer = (*this)(std::span<const Vec2>(polygon.outer));
    for (Ring& hole : polygon.holes) hole = (*this)(std::span<const Vec2>(hole));
    return polygon;
}

Partition GrainMap::back(Partition partition, const Polygon& outline) const {
    const Polygon mapped = (*this)(outline);
    CornerPairs corners;
    addCorners(mapped.outer, outline.outer, partition.origin, m_origin, corners);
    for (std::size_t hole = 0; hole < outline.holes.size(); ++hole)
        addCorners(mapped.holes[hole], outline.holes[hole], partition.origin, m_origin, corners);
    const auto placeOf = [](const auto& corner) { return corner.first; };
    std::ranges::sort(corners, {}, placeOf);
    for (Vec2& point : partition.points) {
        const std::array<double, 2> place{point.x, point.y};
        const auto found = std::ranges::lower_bound(corners, place, {}, placeOf);
        point = found != corners.end() && found->first == place ? found->second : back(point + partition.origin);
    }
    partition.origin = m_origin;
    return partition;
}

Partition GrainMap::operator()(Partition partition) const {
    for (Vec2& point : partition.points) point = (*this)(point + partition.origin);
    partition.origin = {0.0, 0.0};
    return partition;
}

}  // namespace rubble
