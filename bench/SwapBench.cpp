// The cost of swaps in steps of the same scene: one polytope for ten fragments, one for thirty that are computed at the
// impact, and all polytopes of the house at once. Each is repeated from the same snapshot.
#include "bench/Timing.h"
#include "core/base/Percentile.h"
#include "core/play/session/Session.h"
#include "tests/support/asset/House.h"
#include "tests/support/scenes/Scenes.h"

#include <cstdio>

using namespace rubble;
using bench::millisecondsOf;

namespace {

constexpr double kStep = 1.0 / 60.0;  // s
constexpr int kSettling = 120;        // steps before the measurement
constexpr int kRounds = 50;
constexpr int kStepsAfter = 10;

Session started(const Project& project) {
    Result<std::shared_ptr<const PlayScene>> scene = playScene(project);
    Result<Session> session = Session::start(std::move(*scene), {.sleeping = false});
    for (int step = 0; step < kSettling; ++step) session->step();
    return std::move(*session);
}

/// Medians over all rounds, in milliseconds.
struct Cost {
    double step = 0.0;      // of the scene without a swap
    double swap = 0.0;      // removing wholes, adding fragments
    double withSwap = 0.0;  // of the step with the swap, including the first collision of the fragments
    double after = 0.0;     // of the ten steps that follow
};

Cost costOf(Session& session, const std::vector<std::uint32_t>& bodies) {
    const std::shared_ptr<const SessionSnapshot> standing = session.snapshot();
    std::vector<double> steps, swaps, withSwaps, afters;
    for (int round = 0; round < kRounds; ++round) {
        session.restore(*standing);
        for (int k = 0; k < kStepsAfter; ++k) steps.push_back(millisecondsOf([&] { session.step(); }));
        for (const std::uint32_t body : bodies) static_cast<void>(session.add(BreakInput{body}));
        withSwaps.push_back(millisecondsOf([&] { session.step(); }));
        double swap = 0.0;
        for (const PlayBreak& broken : session.events().breaks) swap += broken.milliseconds;
        swaps.push_back(swap);
        for (int k = 0; k < kStepsAfter; ++k) afters.push_back(millisecondsOf([&] { session.step(); }));
    }
    session.restore(*standing);
    return {percentile(steps, 0.5), percentile(swaps, 0.5), percentile(withSwaps, 0.5), percentile(afters, 0.5)};
}

std::vector<std::uint32_t> instancesOf(const Session& session, std::size_t most) {
    std::vector<std::uint32_t> bodies;
    for (const PlayBody& body : session.bodies()) {
        if (body.role == PlayRole::Instance && bodies.size() < most) bodies.push_back(body.number);
    }
    return bodies;
}

Project houseInPieces(std::uint32_t pieces) {
    Project project = test::house();
    for (PatternLayer& layer : project.assets[0].pattern.layers) {
        if (auto* scatter = std::get_if<UniformScatter>(&layer.parameters)) scatter->count = pieces;
    }
    return project;
}

double stepOfCutHouse() {
    SceneWorld cut = std::move(*makeWorld(test::cutHouseScene(), {.sleeping = false}));
    std::vector<double> times;
    for (int step = 0; step < kSettling; ++step) cut.world.step(kStep);
    for (int step = 0; step < 10 * kStepsAfter; ++step) times.push_back(millisecondsOf([&] { cut.world.step(kStep); }));
    return percentile(times, 0.5);
}

void printRow(const char* name, double milliseconds, const char* of, double other, double limit) {
    std::printf("| %s | %.4f | %s | %.4f | %.2f | %.0f |\n", name, milliseconds, of, other, milliseconds / other,
                limit);
}

}  // namespace

int main() {
    std::printf("| what | ms | against | ms | ratio | at most |\n| --- | --- | --- | --- | --- | --- |\n");
    Session ten = started(houseInPieces(10));
    const Cost one = costOf(ten, instancesOf(ten, 1));
    printRow("one polytope for 10 fragments: the swap", one.swap, "a step of the standing house", one.step, 1.0);
    printRow("the same: what its step takes longer", one.withSwap - one.step, "a step of the standing house", one.step,
             1.0);

    Session house = started(test::house());
    const Cost all = costOf(house, instancesOf(house, 1000));
    printRow("all 77 of the house: the whole step", all.withSwap, "one of the ten steps after", all.after, 3.0);

    Project cutAtImpact = test::house();
    cutAtImpact.assets[0].cutAtImpact = CutAtImpact{.fragments = 30};
    Session cut = started(cutAtImpact);
    const Cost thirty = costOf(cut, instancesOf(cut, 1));
    printRow("one polytope cut into 30 where it is hit", thirty.swap, "a step of the cut house", stepOfCutHouse(), 1.0);
    return 0;
}
