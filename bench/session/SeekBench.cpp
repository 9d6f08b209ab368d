// The time of seeks in the timeline of a street of two-storey houses, each of which is blown up: what a seek replays,
// and the scene that is drawn then. On as many threads as there are processors, in time of the clock.
//
//   SeekBench [HOUSES]   without an argument 40
#include "bench/Timing.h"
#include "bench/session/HouseRows.h"
#include "core/base/Parallel.h"
#include "core/base/Percentile.h"
#include "core/play/session/Timeline.h"
#include "viewport/scene/play/SessionSceneBuilder.h"

#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace rubble;

namespace {

constexpr std::uint64_t kHitStep = 30;
constexpr std::uint64_t kSteps = 300;

struct Times {
    std::vector<double> seek;   // ms
    std::vector<double> scene;  // ms
    void print(const char* name) const {
        std::printf("| %s | %.1f | %.1f | %.1f | %.1f |\n", name, percentile(seek, 0.5), percentile(seek, 1.0),
                    percentile(scene, 0.5), percentile(scene, 1.0));
        std::fflush(stdout);
    }
};

void seek(Timeline& timeline, SessionSceneBuilder& builder, std::uint64_t step, Times& times) {
    times.seek.push_back(bench::millisecondsOf([&] { static_cast<void>(timeline.seek(step)); }));
    times.scene.push_back(bench::millisecondsOf([&] { builder.sceneOf(timeline.session()); }));
}

}  // namespace

int main(int argc, char** argv) {
    const int houses = argc > 1 ? std::atoi(argv[1]) : 40;
    const bench::HouseRow row = bench::blownUpHouses(houses, kHitStep);
    const std::shared_ptr<const PlayScene> scene = *playScene(row.project);
    Timeline timeline(std::move(*Session::start(scene, {.threads = availableProcessors()})), row.inputs);
    SessionSceneBuilder builder(scene, {});
    std::printf("| what | seek, median ms | longest | scene, median ms | longest |\n| --- | --- | --- | --- | --- |\n");
    Times played, back, far;
    for (std::uint64_t step = 0; step < kSteps; ++step) {
        played.seek.push_back(bench::millisecondsOf([&] { static_cast<void>(timeline.step()); }));
        played.scene.push_back(bench::millisecondsOf([&] { builder.sceneOf(timeline.session()); }));
    }
    played.print("a step played");
    std::printf("snapshots: %zu MiB\n", timeline.snapshotBytes() >> 20);
    for (std::uint64_t step = kSteps - 5; step + 100 > kSteps; step -= 5) seek(timeline, builder, step, back);
    back.print("dragging back, 5 steps each");
    for (std::uint64_t k = 0; k < 20; ++k) seek(timeline, builder, (k * 137 + 50) % kSteps, far);
    far.print("a click anywhere");
    std::printf("snapshots: %zu MiB\n", timeline.snapshotBytes() >> 20);
    return 0;
}
