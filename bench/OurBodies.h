#pragma once

#include "core/physics/world/BodyScene.h"

#include <utility>
#include <vector>

namespace rubble::bench {

/// A scene simulated by our World, without sleeping.
class OurBodies {
public:
    explicit OurBodies(const BodyScene& scene, int threads = 1)
        : m_moved(std::move(*makeWorld(scene, {.sleeping = false, .threads = threads}))) {}

    void step(double dt) { m_moved.world.step(dt); }
    std::vector<Pose> poses() const {
        std::vector<Pose> poses;
        for (const BodyId body : m_moved.bodies) poses.push_back(m_moved.world.state(body).pose);
        return poses;
    }
    std::size_t contactPoints() const { return static_cast<std::size_t>(m_moved.world.counts().contactPoints); }

private:
    SceneWorld m_moved;
};

}  // namespace rubble::bench
