#include "core/play/scene/BodyShape.h"

#include "core/base/Assert.h"
#include "core/geometry/hull/SimplifiedHull.h"

#include <algorithm>

namespace rubble {
namespace {

Polytope boundingBoxOf(std::span<const Polytope> hulls) {
    RUBBLE_ASSERT(!hulls.empty() && !hulls[0].vertices.empty());
    Vec3 low = hulls[0].vertices[0], high = low;
    for (const Polytope& hull : hulls) {
        for (const Vec3& corner : hull.vertices) {
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
    }
    const Vec3 middle = (low + high) / 2.0;
    const Vec3 half = glm::max((high - low) / 2.0, Vec3(kMinThickness / 2.0));
    const std::vector<Vec2> ring{{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}};
    return translated(extruded(ring, -half.z, half.z), middle);
}

}  // namespace

Result<BodyShape> bodyShape(std::span<const Polytope> hulls, const MassProperties& mass) {
    Result<std::shared_ptr<const Shape>> exact = makeShape(hulls, mass);
    if (exact) return BodyShape{std::move(*exact), std::nullopt};
    if (hulls.empty()) return exact.error();
    const auto hasTooManyCorners = [](const Polytope& hull) { return hull.vertices.size() > kMaxHullCorners; };
    if (std::ranges::any_of(hulls, hasTooManyCorners)) {
        std::vector<Polytope> reduced;
        for (const Polytope& hull : hulls)
            reduced.push_back(hasTooManyCorners(hull) ? simplifiedHull(hull, {0.0, kMaxHullCorners}) : hull);
        if (Result<std::shared_ptr<const Shape>> shape = makeShape(reduced, mass)) {
            return BodyShape{std::move(*shape), "It collides as a hull of at most " + std::to_string(kMaxHullCorners) +
                                                    " of its corners."};
        }
    }
    const Polytope box = boundingBoxOf(hulls);
    Result<std::shared_ptr<const Shape>> shape = makeShape({&box, 1}, mass);
    if (!shape) return exact.error();
    return BodyShape{std::move(*shape), "It is too thin to collide as it is and collides as its bounding box."};
}

}  // namespace rubble
