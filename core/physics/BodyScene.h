#pragma once

#include "core/geometry/Polytope.h"
#include "core/physics/World.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

// What the simulation's numbers can carry; beyond it a scene is refused.
inline constexpr double kDensest = 1e6;    // kg/m^3, fifty times the densest metal
inline constexpr double kRoughest = 1e3;   // coefficient of friction
inline constexpr double kLightest = 1e-9;  // kg
inline constexpr double kHeaviest = 1e15;  // kg

/// A body by its name, placed in a scene.
struct SceneBody {
    std::string name;
    BodyKind kind = BodyKind::Dynamic;
    double density = 1000.0;  // kg/m^3; may be 0 where nothing moves the body
    double friction = 0.6;
    double restitution = 0.0;             // in [0, 1]
    Pose pose;                            // of the shape's frame in the world
    Vec3 velocity{0.0, 0.0, 0.0};         // m/s, of the centre of mass
    Vec3 angularVelocity{0.0, 0.0, 0.0};  // rad/s, in world axes
    std::uint32_t shape = 0;              // index in BodyScene::shapes
    bool operator==(const SceneBody&) const = default;
};

/// Plain bodies as a value: what a World is made of, and what tests, benchmarks and the command line hand around.
struct BodyScene {
    Vec3 gravity{0.0, -9.81, 0.0};              // m/s^2
    std::vector<std::vector<Polytope>> shapes;  // the hulls of each in its own frame; shared by any number of bodies
    std::vector<SceneBody> bodies;
    bool operator==(const BodyScene&) const = default;
};

/// Says which body is wrong and how, or nothing: a name that is empty or there twice; numbers that are not finite or out of
/// their range; an orientation whose length is off 1 by more than a thousandth; a shape that is not there or has no hulls;
/// a hull that verifyPolytope() finds fault with, as one that is inside out.
std::optional<std::string> verifyBodyScene(const BodyScene& scene);

/// A scene in motion, and the ids of its bodies in the scene's order.
struct SceneWorld {
    World world;
    std::vector<BodyId> bodies;
};

/// Puts a scene into a world; gravity is the scene's. Orientations are normalised.
///
/// Errors: BadInput where verifyBodyScene() finds a fault; those of makeShape(), for a flat hull say, and a mass outside
/// [kLightest, kHeaviest], with the body's name.
Result<SceneWorld> makeWorld(const BodyScene& scene, const WorldSettings& settings = {});

}  // namespace rubble
