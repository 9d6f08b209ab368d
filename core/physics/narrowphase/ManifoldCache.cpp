#include "core/physics/narrowphase/ManifoldCache.h"

namespace rubble {

std::vector<CachedManifold> cachedManifolds(const Shape& first, const Shape& second, Vec3 offset) {
    const Vec3f centre = toFloat(offset);
    const auto collide = [](const PlacedHull& a, const PlacedHull& b, Vec3f between) {
        return collideHulls(*a.hull, *b.hull, {{}, between + b.offset - a.offset}, kSpeculativeDistance, {});
    };
    std::vector<CachedManifold> manifolds;
    for (std::uint32_t a = 0; a < first.hulls.size(); ++a) {
        for (std::uint32_t b = 0; b < second.hulls.size(); ++b) {
            const HullCollision forward = collide(first.hulls[a], second.hulls[b], centre);
            const HullCollision swapped = collide(second.hulls[b], first.hulls[a], centre * -1.0f);
            if (forward.manifold.count > 0 && swapped.manifold.count > 0)
                manifolds.push_back({{a, b}, {forward, swapped}});
        }
    }
    return manifolds;
}

}  // namespace rubble
