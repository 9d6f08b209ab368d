#include "tests/support/scenes/RotatingScenes.h"

#include "core/base/Random.h"
#include "core/base/math/Trigonometry.h"
#include "core/geometry/hull/ConvexHull.h"
#include "tests/support/scenes/SceneParts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble::test {
namespace {

constexpr double kRodLength = 3.0;         // m
constexpr double kWideGroundHalf = 500.0;  // m: rods that hit it fly far

/// Uniformly distributed logarithms.
double betweenByRatio(Random& random, double low, double high) {
    return std::exp(random.between(std::log(low), std::log(high)));
}

Vec3 randomDirection(Random& random) {
    const double z = random.between(-1.0, 1.0);
    const double angle = 2.0 * std::numbers::pi * random.unit();
    const double radius = std::sqrt(1.0 - z * z);
    return {radius * cosine(angle), radius * sine(angle), z};
}

Vec3 rodOrPlate(Random& random, bool isRod) {
    const double length = random.between(0.5, kRodLength);
    if (isRod) {
        const double side = length / betweenByRatio(random, 20.0, 100.0);
        return {side, length, side * random.between(0.5, 1.0)};
    }
    const double thickness = length / betweenByRatio(random, 10.0, 60.0);
    return {length, length * random.between(0.3, 1.0), thickness};
}

double lowestPoint(const Polytope& hull, Quat orientation) {
    double lowest = 0.0;
    for (const Vec3& vertex : hull.vertices) lowest = std::min(lowest, (orientation * vertex).y);
    return lowest;
}

}  // namespace

BodyScene freeRod(double aspect, Vec3 axis, double radiansPerStep, double dt) {
    BodyScene scene{.gravity = Vec3(0.0)};
    const double side = kRodLength / aspect;
    addFreeBody(scene, "rod", addShape(scene, {boxOf({side, kRodLength, side})}), {});
    scene.bodies.back().angularVelocity = radiansPerStep / dt * axis;
    return scene;
}

BodyScene freeSolid(std::uint64_t randomSeed, double dt) {
    constexpr double kSlenderness = 30.0;
    BodyScene scene{.gravity = Vec3(0.0)};
    Random random(randomSeed);
    Vec3 extent;
    for (int axis = 0; axis < 3; ++axis) extent[axis] = betweenByRatio(random, 1.0 / kSlenderness, 1.0);
    std::vector<Vec3> points(6 + random.below(15));
    for (Vec3& point : points) point = extent * randomIn(random, 1.0);
    const Quat orientation = randomRotation(random);
    addFreeBody(scene, "solid", addShape(scene, {*convexHull(points)}), {.orientation = orientation});
    const double rate = betweenByRatio(random, 0.05, 2.0) / dt;
    scene.bodies.back().angularVelocity = rate * randomDirection(random);
    return scene;
}

BodyScene rotatingOntoGround(std::uint64_t randomSeed, double dt) {
    BodyScene scene;
    addGround(scene, kWideGroundHalf);
    Random random(randomSeed);
    const Polytope hull = boxOf(rodOrPlate(random, randomSeed % 2 == 0));
    const Quat orientation = randomRotation(random);
    const double height = random.between(0.0, 0.3) - lowestPoint(hull, orientation);
    addFreeBody(scene, "body", addShape(scene, {hull}), {{0.0, height, 0.0}, orientation});
    SceneBody& body = scene.bodies.back();
    const double rate = betweenByRatio(random, 0.1, 1.0) / dt;
    body.angularVelocity = rate * randomDirection(random);
    body.velocity = randomIn(random, 1.0) - Vec3(0.0, random.between(0.0, 2.0), 0.0);
    return scene;
}

}  // namespace rubble::test
