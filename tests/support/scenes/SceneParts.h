#pragma once

#include "core/physics/world/BodyScene.h"
#include "tests/support/geometry/Hulls.h"

#include <string>
#include <utility>

namespace rubble::test {

/// Adds a shape. Returns its index.
inline std::uint32_t addShape(BodyScene& scene, std::vector<Polytope> hulls) {
    scene.shapes.push_back(std::move(hulls));
    return static_cast<std::uint32_t>(scene.shapes.size() - 1);
}

/// Adds a static box by its lowest and highest corner.
inline void addFixedBox(BodyScene& scene, const std::string& name, Vec3 low, Vec3 high) {
    const std::uint32_t shape = addShape(scene, {boxOf(high - low)});
    scene.bodies.push_back(
        {.name = name, .kind = BodyKind::Static, .pose = {.position = 0.5 * (low + high)}, .shape = shape});
}

/// Adds a ground whose top is the plane y = 0.
inline void addGround(BodyScene& scene, double halfWidth) {
    addFixedBox(scene, "ground", {-halfWidth, -1.0, -halfWidth}, {halfWidth, 0.0, halfWidth});
}

/// Adds a dynamic body.
inline void addFreeBody(BodyScene& scene, const std::string& name, std::uint32_t shape, const Pose& pose) {
    scene.bodies.push_back({.name = name, .pose = pose, .shape = shape});
}

}  // namespace rubble::test
