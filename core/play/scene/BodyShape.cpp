#include "core/play/scene/BodyShape.h"

#include "core/base/Assert.h"
#include "core/base/math/Trigonometry.h"
#include "core/geometry/hull/ConvexHull.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble {
namespace {

/// `count` evenly distributed directions.
/// Source: the spiral of Vogel 1979, on the sphere.
std::vector<Vec3> fibonacciSphere(int count) {
    const double goldenAngle = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<Vec3> directions;
    for (int k = 0; k < count; ++k) {
        const double z = 1.0 - (2.0 * k + 1.0) / count, radius = std::sqrt(1.0 - z * z);
        directions.push_back({radius * cosine(goldenAngle * k), radius * sine(goldenAngle * k), z});
    }
    return directions;
}

/// The hull of the extreme corners in many directions.
Polytope reducedHull(const Polytope& hull) {
    std::vector<std::size_t> kept;
    for (const Vec3& direction : fibonacciSphere(kMaxHullCorners)) {
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
    Result<Polytope> reduced = convexHull(corners);
    return reduced ? std::move(*reduced) : hull;
}

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
        for (const Polytope& hull : hulls) reduced.push_back(hasTooManyCorners(hull) ? reducedHull(hull) : hull);
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
