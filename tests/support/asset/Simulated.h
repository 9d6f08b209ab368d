#pragma once

#include "core/physics/queries/Penetration.h"
#include "core/physics/world/BodyScene.h"

#include <QTest>

#include <cstdlib>
#include <string>
#include <vector>

namespace rubble::test {

inline constexpr double kStep = 1.0 / 60.0;  // s

/// A world that must be possible.
inline SceneWorld worldOf(const BodyScene& scene, const WorldSettings& settings = {}) {
    Result<SceneWorld> made = makeWorld(scene, settings);
    if (!made) qFatal("%s", made.error().message.c_str());
    return std::move(*made);
}

inline void simulate(World& world, double seconds, double dt = kStep) {
    const auto steps = static_cast<int>(std::lround(seconds / dt));
    for (int step = 0; step < steps; ++step) world.step(dt);
}

inline std::vector<Pose> posesOf(const SceneWorld& moved) {
    std::vector<Pose> poses;
    for (const BodyId body : moved.bodies) poses.push_back(moved.world.state(body).pose);
    return poses;
}

/// How far the body that moved farthest is from where the scene has it, m.
inline double farthestMoved(const BodyScene& scene, const SceneWorld& moved) {
    double farthest = 0.0;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
        const Vec3 now = moved.world.state(moved.bodies[k]).pose.position;
        farthest = std::max(farthest, glm::distance(now, scene.bodies[k].pose.position));
    }
    return farthest;
}

inline bool areAllAsleep(const SceneWorld& moved) {
    for (const BodyId body : moved.bodies) {
        if (moved.world.kind(body) == BodyKind::Dynamic && !moved.world.state(body).asleep) return false;
    }
    return true;
}

inline double energyOf(const World& world) { return world.momenta().kinetic + world.momenta().potential; }

/// True if the long runs are enabled: ctest -C Long.
inline bool isLongRun() { return qEnvironmentVariableIsSet("RUBBLE_LONG"); }

}  // namespace rubble::test

Q_DECLARE_METATYPE(rubble::BodyScene)
