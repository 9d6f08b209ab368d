// Compares the steps of scenes in motion with Bullet: means and the worst step of each phase. One thread, in time of
// the processor, without sleeping.
//
//   BurstBench [ROUNDS [SCENE]...]    for example: BurstBench 3 burst-4700-12 heap-2000
#include "bench/BulletBodies.h"
#include "bench/OurBodies.h"
#include "bench/Phases.h"
#include "tests/support/scenes/Scenes.h"

#include <cstdlib>

using namespace rubble;

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 1;
    std::vector<std::string> names(argv + std::min(argc, 2), argv + argc);
    if (names.empty()) names = {"heap-600", "tower-24", "burst-1000-4", "burst-1000-12", "burst-1000-30"};
    std::printf(
        "| scene | bodies | phase | ours, mean / worst, ms | Bullet | Bullet : ours |\n"
        "| --- | --- | --- | --- | --- | --- |\n");
    for (const std::string& name : names) {
        const BodyScene scene = test::sceneNamed(name);
        if (scene.bodies.empty()) return std::fprintf(stderr, "There is no scene \"%s\".\n", name.c_str()), 2;
        std::vector<std::pair<std::string, bench::PhaseResult>> all{{"ours", {}}, {"Bullet", {}}};
        for (int round = 0; round < rounds; ++round) {
            bench::playPhases<bench::OurBodies>(scene, all[0].second);
            bench::playPhases<bench::BulletBodies>(scene, all[1].second);
        }
        bench::printPhases(name, test::freeBodies(scene), all);
    }
    return 0;
}
