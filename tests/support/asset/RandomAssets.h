#pragma once

#include "core/base/Random.h"
#include "core/base/math/Power.h"
#include "core/base/math/Trigonometry.h"
#include "tests/support/asset/ProjectParts.h"
#include "tests/support/geometry/Outlines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble::test {

/// A magnitude between two, each decade as likely.
inline double magnitudeIn(Random& random, double low, double high) {
    return power(10.0, random.between(std::log10(low), std::log10(high)));
}

/// Scales a prism.
inline void scale(Prism& prism, double size) {
    for (Vec2& point : prism.outline.outer) point *= size;
    for (Ring& hole : prism.outline.holes) {
        for (Vec2& point : hole) point *= size;
    }
    prism.depth *= size;
}

/// A random outline within 1 m of the origin: convex, concave, or with a hole, depending on `kind`.
inline Polygon randomOutline(Random& random, int kind) {
    const int corners = 3 + static_cast<int>(random.below(6));
    const double start = random.between(0.0, 1.0), aspect = random.between(0.3, 1.0);
    Polygon outline;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi * (k + start) / corners;
        const double radius = kind % 3 == 1 ? random.between(0.3, 1.0) : 1.0;  // a star, or on an ellipse
        outline.outer.push_back(radius * Vec2(cosine(angle), aspect * sine(angle)));
    }
    if (kind % 3 == 2) {
        const Vec2 half(random.between(0.04, 0.1), random.between(0.02, 0.08));
        outline.holes.push_back(reversed(rectangle(-half, half)));
    }
    return outline;
}

/// A project with one asset of random outline, material and size and four fragments, and a ground with restitution.
inline Project randomAsset(Random& random, int kind) {
    Project project;
    const Id stone = addMaterial(project, {.name = "stone",
                                           .density = random.between(500.0, 3000.0),
                                           .friction = random.between(0.0, 1.0),
                                           .restitution = random.between(0.0, 0.6)});
    project.ground.restitution = random.between(0.0, 0.6);
    addAsset(
        project,
        {.name = "asset", .material = stone, .shape = Prism{randomOutline(random, kind), random.between(0.1, 0.6)}},
        {UniformScatter{.count = 4}});
    return project;
}

}  // namespace rubble::test
