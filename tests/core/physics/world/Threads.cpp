#include "tests/support/scenes/Scenes.h"

#include <cstdio>
#include <string>

using namespace rubble;

namespace {

/// The hash of a heap that fell for two seconds, with bodies removed and added meanwhile.
std::string hashOfHeap(int threads) {
    const BodyScene scene = test::heapScene(600);
    Result<SceneWorld> moved = makeWorld(scene, {.threads = threads});
    if (!moved) return moved.error().message;
    for (int step = 0; step < 120; ++step) {
        moved->world.collide(1.0 / 60.0);
        if (step % 30 == 29) {
            const BodyId body = moved->bodies[static_cast<std::size_t>(5 + step)];
            const BodyState state = moved->world.state(body);
            const auto shape = makeShape(scene.shapes[scene.bodies[static_cast<std::size_t>(5 + step)].shape]);
            moved->world.removeBody(body);
            if (shape) (void)moved->world.addBody({.shape = *shape, .pose = state.pose, .velocity = state.velocity});
            moved->world.collide(1.0 / 60.0);
        }
        moved->world.solve(1.0 / 60.0);
    }
    return moved->world.hash().hex();
}

}  // namespace

/// Simulates a heap on three threads, for ThreadSanitizer: a plain program, since Qt Test's watchdog races under it.
/// The hash must equal that of one thread.
int main() {
    const std::string one = hashOfHeap(1), three = hashOfHeap(3);
    std::printf("one thread:    %s\nthree threads: %s\n", one.c_str(), three.c_str());
    return one == three ? 0 : 1;
}
