// The time of seeks in the timeline of a street of two-storey houses, each of which is blown up: what a seek replays,
// the scene that is drawn then, and the recorded one that is drawn until then. On as many threads as there are
// processors, in time of the clock.
//
//   SeekBench [HOUSES]   without an argument 40
#include "bench/Timing.h"
#include "bench/session/HouseRows.h"
#include "core/base/Parallel.h"
#include "core/base/Percentile.h"
#include "core/play/session/Timeline.h"
#include "viewport/scene/play/SceneRecording.h"
#include "viewport/scene/play/SessionSceneBuilder.h"

#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace rubble;

namespace {

constexpr std::uint64_t kHitStep = 30;
constexpr std::uint64_t kSteps = 300;

struct Times {
    std::vector<double> seek;       // ms
    std::vector<double> scene;      // ms
    std::vector<double> recording;  // ms: recording a step, or showing the recorded one
    void print(const char* name) const {
        std::printf("| %s ", name);
        for (const std::vector<double>* times : {&seek, &scene, &recording})
            std::printf("| %.1f | %.1f ", percentile(*times, 0.5), percentile(*times, 1.0));
        std::printf("|\n");
        std::fflush(stdout);
    }
};

/// A session that is recorded while it is played.
struct Played {
    Timeline timeline;
    SessionSceneBuilder builder;
    SceneRecording recording;

    void record() {
        const Session& session = timeline.session();
        recording.add(session.stepsDone(), builder.momentOf(session), session.events());
    }
    void step(Times& times) {
        times.seek.push_back(bench::millisecondsOf([&] { static_cast<void>(timeline.step()); }));
        times.scene.push_back(bench::millisecondsOf([&] { builder.sceneOf(timeline.session()); }));
        times.recording.push_back(bench::millisecondsOf([&] { record(); }));
    }
    void seek(std::uint64_t step, Times& times) {
        times.recording.push_back(
            bench::millisecondsOf([&] { recording.sceneAt(recording.lastStepUntil(step).value()); }));
        times.seek.push_back(bench::millisecondsOf([&] { static_cast<void>(timeline.seek(step)); }));
        times.scene.push_back(bench::millisecondsOf([&] { builder.sceneOf(timeline.session()); }));
    }
    void printMemory() const {
        std::printf("snapshots: %zu MiB, recording of %zu steps: %zu MiB\n", timeline.snapshotBytes() >> 20,
                    recording.stepCount(), recording.bytes() >> 20);
    }
};

}  // namespace

int main(int argc, char** argv) {
    const int houses = argc > 1 ? std::atoi(argv[1]) : 40;
    const bench::HouseRow row = bench::blownUpHouses(houses, kHitStep);
    const std::shared_ptr<const PlayScene> scene = *playScene(row.project);
    Played street{
        .timeline = Timeline(std::move(*Session::start(scene, {.threads = availableProcessors()})), row.inputs),
        .builder = SessionSceneBuilder(scene),
        .recording = SceneRecording(scene, SessionSettings().dt)};
    street.record();
    std::printf("| what | seek, median ms | longest | scene, median ms | longest | recording, median ms | longest |\n");
    std::printf("| --- | --- | --- | --- | --- | --- | --- |\n");
    Times played, back, far;
    for (std::uint64_t step = 0; step < kSteps; ++step) street.step(played);
    played.print("a step played");
    street.printMemory();
    for (std::uint64_t step = kSteps - 5; step + 100 > kSteps; step -= 5) street.seek(step, back);
    back.print("dragging back, 5 steps each");
    for (std::uint64_t k = 0; k < 20; ++k) street.seek((k * 137 + 50) % kSteps, far);
    far.print("a click anywhere");
    street.printMemory();
    return 0;
}
