// Compares the step time of the simulation on one and two threads with Bullet on the same scenes, and the penetration
// after it. All are stepped alternately, so that other load slows all of them.
//
//   PhysicsBench [scene]...    for example: PhysicsBench heap-2000 wall
#include "bench/BulletBodies.h"
#include "bench/OurBodies.h"
#include "bench/Timing.h"
#include "core/base/Percentile.h"
#include "core/physics/queries/Penetration.h"
#include "tests/support/scenes/Scenes.h"

#include <cstdio>
#include <span>
#include <string>

using namespace rubble;

namespace {

constexpr double kStep = 1.0 / 60.0;  // s
constexpr int kSettling = 120;        // steps before the measurement
constexpr int kTimed = 300;
constexpr int kBatch = 20;  // steps of one before the next

/// A simulation and the milliseconds of each step.
template <class Bodies>
struct Runner {
    Bodies bodies;
    std::vector<double> times;

    void run(int steps) {
        for (int k = 0; k < steps; ++k) times.push_back(bench::millisecondsOf([&] { bodies.step(kStep); }));
    }
    double median() const { return percentile({times.begin() + kSettling, times.end()}, 0.5); }
};

void measure(const std::string& name, const BodyScene& scene) {
    Runner<bench::OurBodies> one{bench::OurBodies(scene, 1), {}};
    Runner<bench::OurBodies> two{bench::OurBodies(scene, 2), {}};
    Runner<bench::BulletBodies> bullet{bench::BulletBodies(scene), {}};
    for (int step = 0; step < kSettling + kTimed; step += kBatch) {
        one.run(kBatch);
        two.run(kBatch);
        bullet.run(kBatch);
    }
    const Penetration ours = penetrationOf(scene, one.bodies.poses());
    const Penetration theirs = penetrationOf(scene, bullet.bodies.poses());
    std::printf("| %s | %zu | %zu | %.3f | %.3f | %.3f | %.1f | %.2f | %.1f / %.2f | %.1f / %.2f |\n", name.c_str(),
                test::freeBodies(scene), one.bodies.contactPoints(), one.median(), two.median(), bullet.median(),
                bullet.median() / one.median(), one.median() / two.median(), 1e3 * ours.largest, 1e3 * ours.mean,
                1e3 * theirs.largest, 1e3 * theirs.mean);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> names(argv + 1, argv + argc);
    if (names.empty()) {
        names = {"house", "cut-house", "wall", "pyramid", "heap-600", "heap-2000", "heap-3350", "heap-5000"};
    }
    std::printf(
        "| scene | bodies | points | ours, ms | ours on 2 threads, ms | Bullet, ms | Bullet : ours "
        "| 1 thread : 2 | our overlap, max / mean, mm | Bullet's |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const std::string& name : names) {
        const BodyScene scene = test::sceneNamed(name);
        if (scene.bodies.empty()) {
            std::fprintf(stderr, "There is no scene \"%s\".\n", name.c_str());
            return 2;
        }
        measure(name, scene);
    }
    return 0;
}
