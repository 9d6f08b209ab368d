#pragma once

#include "core/play/session/Session.h"
#include "tests/support/asset/ProjectParts.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <cmath>
#include <cstdlib>

namespace rubble::test {

/// A scene that must be playable.
inline std::shared_ptr<const PlayScene> playSceneOf(const Project& project) {
    Result<std::shared_ptr<const PlayScene>> scene = playScene(project);
    if (!scene) qFatal("%s", scene.error().message.c_str());
    return std::move(*scene);
}

inline Session sessionOf(const Project& project, const SessionSettings& settings = {}) {
    Result<Session> session = Session::start(playSceneOf(project), settings);
    if (!session) qFatal("%s", session.error().message.c_str());
    return std::move(*session);
}

/// The scene of a session, which must outlive it.
inline std::shared_ptr<const PlayScene> sharedScene(const Session& session) {
    return {std::shared_ptr<const PlayScene>(), &session.scene()};
}

inline const PlayAsset& onlyAsset(const PlayScene& scene) { return *scene.assets.begin()->second; }

/// A block of 1 x 1 x 0.5 m in `pieces` fragments, of density 1000 and threshold 100 N·s, above the ground, without
/// gravity.
inline Project floatingBlock(std::uint32_t pieces = 5) {
    Project project;
    const Id stone = addMaterial(project, {.name = "stone", .density = 1000.0});
    const Id block = addAsset(
        project, {.name = "block", .material = stone, .shape = Prism{{rectangle({-0.5, -0.5}, {0.5, 0.5}), {}}, 0.5}},
        {UniformScatter{.count = pieces}});
    addInstance(project, block, "block", {.position = {0.0, 5.0, 0.0}});
    project.gravity = Vec3(0.0);
    return project;
}

/// A box of 0.2 m thrown along -z at (0, 5, 0).
inline Throw throwAtBlock(double mass, double speed) {
    return {.size = {0.2, 0.2, 0.2}, .mass = mass, .from = {0.0, 5.0, 1.0}, .to = {0.0, 5.0, 0.0}, .speed = speed};
}

/// Adds an input that must be valid.
inline void addInput(Session& session, const PlayInput& input) {
    if (const Status added = session.add(input); !added) qFatal("%s", added.error().message.c_str());
}

/// All breaks of the next steps.
inline std::vector<PlayBreak> breaksWithin(Session& session, int steps) {
    std::vector<PlayBreak> breaks;
    for (int k = 0; k < steps; ++k) {
        session.step();
        breaks.insert(breaks.end(), session.events().breaks.begin(), session.events().breaks.end());
    }
    return breaks;
}

inline std::uint32_t countOf(const Session& session, PlayRole role) {
    std::uint32_t count = 0;
    for (const PlayBody& body : session.bodies()) count += body.role == role ? 1 : 0;
    return count;
}

}  // namespace rubble::test
