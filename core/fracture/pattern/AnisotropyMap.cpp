#include "core/fracture/pattern/AnisotropyMap.h"

#include "core/base/math/Trigonometry.h"
#include "core/fracture/pattern/Pattern.h"
#include "core/geometry/polygon/LocalFrame.h"

#include <algorithm>

namespace rubble {
namespace {

/// Mapped corners of the outline, and their originals.
using CornerPairs = std::vector<std::pair<std::array<double, 2>, Vec2>>;

void addCorners(const Ring& mapped, const Ring& ring, Vec2 mappedOrigin, Vec2 origin, CornerPairs& pairs) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 position = mapped[k] - mappedOrigin;
        pairs.push_back({{position.x, position.y}, ring[k] - origin});
    }
}

}  // namespace

std::optional<AnisotropyMap> AnisotropyMap::of(const Pattern& pattern, const Polygon& outline) {
    std::optional<AnisotropyMap> all;
    for (const PatternLayer& layer : pattern.layers) {
        const auto* grain = std::get_if<Grain>(&layer.parameters);
        if (!grain || !layer.isOn || grain->ratio == 1.0) continue;
        const Vec2 along(cosine(grain->angle), sine(grain->angle)), across = perpendicular(along);
        AnisotropyMap map;
        map.m_origin = localFrame(outline).origin;
        for (const std::size_t axis : {0u, 1u}) {
            const auto part = static_cast<int>(axis);
            map.m_forward[axis] = along * (along[part] / grain->ratio) + across * across[part];
            map.m_inverse[axis] = along * (along[part] * grain->ratio) + across * across[part];
        }
        if (all) {
            map.m_forward = {map.apply(all->m_forward[0]), map.apply(all->m_forward[1])};
            map.m_inverse = {all->applyInverse(map.m_inverse[0]), all->applyInverse(map.m_inverse[1])};
        }
        all = map;
    }
    return all;
}

std::vector<Vec2> AnisotropyMap::operator()(std::span<const Vec2> points) const {
    std::vector<Vec2> mapped;
    mapped.reserve(points.size());
    for (const Vec2 point : points) mapped.push_back((*this)(point));
    return mapped;
}

Polygon AnisotropyMap::operator()(Polygon polygon) const {
    polygon.outer = (*this)(std::span<const Vec2>(polygon.outer));
    for (Ring& hole : polygon.holes) hole = (*this)(std::span<const Vec2>(hole));
    return polygon;
}

Partition AnisotropyMap::inverse(Partition partition, const Polygon& outline) const {
    const Polygon mapped = (*this)(outline);
    CornerPairs corners;
    addCorners(mapped.outer, outline.outer, partition.origin, m_origin, corners);
    for (std::size_t hole = 0; hole < outline.holes.size(); ++hole)
        addCorners(mapped.holes[hole], outline.holes[hole], partition.origin, m_origin, corners);
    const auto positionOf = [](const auto& corner) { return corner.first; };
    std::ranges::sort(corners, {}, positionOf);
    for (Vec2& point : partition.points) {
        const std::array<double, 2> position{point.x, point.y};
        const auto found = std::ranges::lower_bound(corners, position, {}, positionOf);
        point =
            found != corners.end() && found->first == position ? found->second : applyInverse(point + partition.origin);
    }
    partition.origin = m_origin;
    return partition;
}

Partition AnisotropyMap::operator()(Partition partition) const {
    for (Vec2& point : partition.points) point = (*this)(point + partition.origin);
    partition.origin = {0.0, 0.0};
    return partition;
}

}  // namespace rubble
