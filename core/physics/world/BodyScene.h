#pragma once

#include "core/geometry/hull/Polytope.h"
#include "core/physics/queries/Penetration.h"
#include "core/physics/world/World.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubble {

// The limits of a scene, given by the simulation's single precision.
inline constexpr double kMaxDensity = 1e6;    // kg/m³, fifty times the densest metal
inline constexpr double kMaxFriction = 1e3;   // coefficient of friction
inline constexpr double kMinBodyMass = 1e-9;  // kg
inline constexpr double kMaxBodyMass = 1e15;  // kg

/// A named body of a scene.
struct SceneBody {
    std::string name;
    BodyKind kind = BodyKind::Dynamic;
    double density = 1000.0;  // kg/m³; may be 0 unless dynamic
    double friction = 0.6;
    double restitution = 0.0;             // in [0, 1]
    Pose pose;                            // world from the shape's frame
    Vec3 velocity{0.0, 0.0, 0.0};         // m/s, of the centre of mass
    Vec3 angularVelocity{0.0, 0.0, 0.0};  // rad/s, in world axes
    std::uint32_t shape = 0;              // index in BodyScene::shapes
    bool operator==(const SceneBody&) const = default;
};

/// The bodies of a world as a value, for tests, benchmarks and the command line.
struct BodyScene {
    Vec3 gravity{0.0, -9.81, 0.0};  // m/s²
    std::vector<std::vector<Polytope>>
        shapes;  // the hulls of each shape in its frame; several bodies may share a shape
    std::vector<SceneBody> bodies;
    bool operator==(const BodyScene&) const = default;
};

/// Names the first invalid body and why, or returns nothing: an empty or duplicate name; numbers that are not finite or
/// out of range; an orientation whose length differs from 1 by more than 0.001; a shape that does not exist or has no
/// hulls; a hull that verifyPolytope() rejects.
std::optional<std::string> verifyBodyScene(const BodyScene& scene);

/// The world of a scene, and the ids of its bodies in the scene's order.
struct SceneWorld {
    World world;
    std::vector<BodyId> bodies;
};

/// Creates the world of a scene, with the scene's gravity. Orientations are normalized.
///
/// Errors: BadInput if verifyBodyScene() rejects the scene; those of makeShape() and BadInput for a mass outside
/// [kMinBodyMass, kMaxBodyMass], with the body's name.
Result<SceneWorld> makeWorld(const BodyScene& scene, const WorldSettings& settings = {});

/// The penetration of a scene's bodies at `poses`, one per body.
Penetration penetrationOf(const BodyScene& scene, std::span<const Pose> poses);

}  // namespace rubble
