#include "core/play/BodyShape.h"

#include "core/base/Assert.h"
#include "core/base/Trigonometry.h"
#include "core/geometry/ConvexHull.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble {
namespace {

/// `count` directions spread evenly over the sphere.
/// Source: the spiral of Vogel 1979, on the sphere.
std::vector<Vec3> evenDirections(int count) {
    const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<Vec3> directions;
    for (int k = 0; k < count; ++k) {
        const double z = 1.0 - (2.0 * k + 1.0) / count, radius = std::sqrt(1.0 - z * z);
        directions.push_back({radius * cosine(turn * k), radius * sine(turn * k), z});
    }
    return directions;
}

/// The hull of the corners that lie farthest in many directions.
Polytope ofFarthestCorners(const Polytope& hull) {
    std::vector<std::size_t> kept;
    for (const Vec3& direction : evenDirections(kMostHullCorners)) {
        const auto farther = [&](const Vec3& a, const Vec3& b) {
            return glm::dot(a, direction) < glm::dot(b, direction);
        };
        kept.push_back(
            static_cast<std::size_t>(std::ranges::max_element(hull.vertices, farther) - hull.vertices.begin()));
    }
    std::ranges::sort(kept);
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    std::vector<Vec3> corners;
    for (const std::size_t index : kept) corners.push_back(hull.vertices[index]);
    Result<Polytope> simpler = convexHull(corners);
    return simpler ? std::move(*simpler) : hull;
}

Polytope boxAround(std::span<const Polytope> hulls) {
    Vec3 low = hulls[0].vertices[0], high = low;
    for (const Polytope& hull : hulls) {
        for (const Vec3& corner : hull.vertices) {
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
    }
    const Vec3 middle = (low + high) / 2.0;
    const Vec3 half = glm::max((high - low) / 2.0, Vec3(kThinnest / 2.0));
    const std::vector<Vec2> ring{{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}};
    return translated(extruded(ring, -half.z, half.z), middle);
}

}  // namespace

Result<BodyShape> bodyShape(std::span<const Polytope> hulls, const MassProperties& mass) {
    Result<std::shared_ptr<const Shape>> exact = makeShape(hulls, mass);
    if (exact) return BodyShape{std::move(*exact), std::nullopt};
    if (hulls.empty()) return exact.error();
    const auto isRich = [](const Polytope& hull) { return hull.vertices.size() > kMostHullCorners; };
    if (std::ranges::any_of(hulls, isRich)) {
        std::vector<Polytope> simpler;
        for (const Polytope& hull : hulls) simpler.push_back(isRich(hull) ? ofFarthestCorners(hull) : hull);
        if (Result<std::shared_ptr<const Shape>> shape = makeShape(simpler, mass)) {
            return BodyShape{std::move(*shape), "It collides as a hull of at most " + std::to_string(kMostHullCorners) +
                                                    " of its corners."};
        }
    }
    const Polytope box = boxAround(hulls);
    Result<std::shared_ptr<const Shape>> shape = makeShape({&box, 1}, mass);
    if (!shape) return exact.error();
    return BodyShape{std::move(*shape), "It is too thin to collide as it is, and does so as a box around it."};
}

}  // namespace rubble
