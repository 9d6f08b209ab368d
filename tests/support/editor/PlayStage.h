#pragma once

#include "core/asset/bake/Bake.h"
#include "editor/play/PlayController.h"
#include "tests/support/play/Sessions.h"

#include <QCoreApplication>

namespace rubble::test {

/// A ray at the block of floatingBlock(), from above.
inline const Ray kAtBlock{{0.0, 5.0, 4.0}, {0.0, 0.0, -1.0}};

/// Tools whose throw breaks that block.
inline PlayToolSettings heavyBox() {
    PlayToolSettings tools;
    tools.projectile = {.size = Vec3(0.2), .mass = 3.0, .speed = 80.0};
    tools.isSpeedAutomatic = false;
    return tools;
}

/// A document in play, with a clock that the test advances.
class Stage {
public:
    static constexpr double kStep = 1.0 / 60.0;  // s

    explicit Stage(const Project& project = floatingBlock()) : document(project), controller(document, bakes) {
        controller.thread().useSteppedClock();
        bake();
    }
    /// Bakes all assets, as the editor does in the background.
    void bake() {
        for (const Asset& asset : document.project().assets) {
            const Result<Bake> made = rubble::bake(asset);
            if (!made) qFatal("%s", made.error().message.c_str());
            const auto shared = std::make_shared<const Asset>(asset);
            bakes.set(asset.id, std::make_shared<const BakedAsset>(
                                    BakedAsset{shared, std::make_shared<const Bake>(*made), std::nullopt}));
        }
    }
    void settle() {
        controller.thread().settle();
        controller.applyUpdate();
    }
    void start() {
        controller.play();
        settle();
        if (!controller.isPlaying()) qFatal("it does not play");
    }
    void advance(int steps) {
        for (int k = 0; k < steps; ++k) controller.thread().advance(kStep);
        controller.applyUpdate();
    }
    /// Plays steps on, also where everything rests, which the clock alone does not.
    void playOn(int steps) {
        controller.pause();
        controller.thread().post([steps](PlayEngine& engine) {
            for (int k = 0; k < steps; ++k) engine.step();
        });
        settle();
        controller.play();
        settle();
    }
    /// The recording so far; of length 0 without a session.
    PlayScript script() {
        PlayScript received;
        controller.requestScript([&](PlayScript script) { received = std::move(script); });
        controller.thread().settle();
        QCoreApplication::sendPostedEvents(&controller);
        return received;
    }
    std::uint64_t step() const { return controller.frame()->step; }
    ContentHash hash() {
        ContentHash hash;
        controller.thread().post([&](PlayEngine& engine) { hash = engine.session().hash(); });
        controller.thread().settle();
        return hash;
    }

    Document document;
    Bakes bakes;
    PlayController controller;
};

}  // namespace rubble::test
