#pragma once

#include "bench/BoxAssets.h"
#include "core/play/session/Session.h"

namespace rubble::bench {

/// Boxes of 100 pieces each, high above the ground and apart from one another, as many as make so many pieces.
inline std::shared_ptr<const PlayScene> boxesInTheAir(std::size_t pieces) {
    Project project;
    project.materials = {{.id = 3, .name = "stone"}};
    project.assets = {boxAssets(100).front()};
    project.assets[0].id = 2;
    project.assets[0].material = 3;
    project.nextId = 10;
    for (std::size_t k = 0; k < pieces / 100; ++k) {
        const Vec3 position(3.0 * static_cast<double>(k % 20), 50.0, 3.0 * static_cast<double>(k / 20));
        project.instances.push_back(
            {.id = project.nextId++, .name = "box " + std::to_string(k), .asset = 2, .pose = {.position = position}});
    }
    return playScene(project).value();
}

/// All of them broken, one step after.
inline Session brokenBoxes(const std::shared_ptr<const PlayScene>& scene) {
    Session session = Session::start(scene, {}).value();
    for (const PlayBody& body : session.bodies()) {
        if (body.role == PlayRole::Instance) (void)session.add(BreakInput{body.number});
    }
    session.step();
    return session;
}

}  // namespace rubble::bench
