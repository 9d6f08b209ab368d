#pragma once

#include "core/base/Random.h"
#include "tests/support/play/Sessions.h"

namespace rubble::test {

/// Three blocks in five fragments of three each, on the ground; the last one is cut where it is hit.
inline Project threeBlocks() {
    Project project = floatingBlock();
    project.gravity = {0.0, -9.81, 0.0};
    project.assets[0].levels = {{.pattern = patternOf(project, {UniformScatter{.count = 3}})}};
    Asset cut = project.assets[0];
    cut.id = project.nextId++;
    cut.name = "cut";
    cut.pattern = patternOf(project, {UniformScatter{.count = 5}});
    cut.levels = {{.pattern = patternOf(project, {UniformScatter{.count = 3}})}};
    cut.cutAtImpact = CutAtImpact{.fragments = 8, .falloffRadius = 0.2};
    project.assets.push_back(cut);
    project.instances[0].pose.position = {0.0, 0.5, 0.0};
    addInstance(project, project.assets[0].id, "second", {.position = {2.0, 0.5, 0.0}});
    addInstance(project, cut.id, "cut", {.position = {4.0, 0.5, 0.0}});
    return project;
}

/// Breaks random bodies: `count` times one.
inline void breakAtRandom(Session& session, int count, Random& random) {
    for (int k = 0; k < count; ++k) {
        const PlayBody& body = session.bodies()[random.below(session.bodies().size())];
        if (body.fracture() != nullptr) addInput(session, BreakInput{body.number});
        session.step();
    }
}

/// The damage after random breaks.
inline SessionDamage randomDamage(const std::shared_ptr<const PlayScene>& scene, Random& random) {
    Result<Session> session = Session::start(scene);
    breakAtRandom(*session, static_cast<int>(random.below(8)), random);
    return session->damage();
}

/// A session that a damage was applied to.
inline Session damaged(const std::shared_ptr<const PlayScene>& scene, const SessionDamage& damage) {
    Result<Session> session = Session::start(scene);
    if (const Status applied = session->apply(damage); !applied) qFatal("%s", applied.error().message.c_str());
    return std::move(*session);
}

}  // namespace rubble::test
