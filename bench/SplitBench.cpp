// The time in which a wall of a thousand bricks loses fifty, and of a step with boxes that lean on the wall, whole and
// with the hole.
//
//   SplitBench
#include "bench/Bricks.h"
#include "bench/Timing.h"
#include "core/base/Percentile.h"

#include <array>
#include <cstdio>

using namespace rubble;
using namespace rubble::bench;

namespace {

constexpr int kRounds = 200;
constexpr int kSettling = 120;  // steps before the measurement
constexpr int kSteps = 600;

struct Split {
    const char* name;
    WallSplit wall;
    std::vector<double> splits, steps;  // ms
};

void measureSplits(const BrickWall& wall) {
    using enum WallHulls;
    std::array splits{Split{"held, of one hull", {wall, One, BodyKind::Static}, {}, {}},
                      Split{"held, of its fragments", {wall, Thousand, BodyKind::Static}, {}, {}},
                      Split{"free, of one hull", {wall, One, BodyKind::Dynamic}, {}, {}},
                      Split{"free, of its fragments", {wall, Thousand, BodyKind::Dynamic}, {}, {}}};
    for (int round = 0; round < kRounds; ++round) {
        for (Split& split : splits) {
            const SplitTimes times = split.wall.round();
            split.splits.push_back(times.split);
            split.steps.push_back(times.step);
        }
    }
    std::printf("| the wall | split, ms | the step after it, ms |\n| --- | --- | --- |\n");
    for (const Split& split : splits) {
        std::printf("| %s | %.4f | %.4f |\n", split.name, percentile(split.splits, 0.5), percentile(split.steps, 0.5));
    }
}

/// A world of the ground, a held wall and the boxes, after it came to rest.
World leaningOn(const std::shared_ptr<const Shape>& wall) {
    World world({.sleeping = false});
    addGround(world);
    static_cast<void>(world.addBody({.shape = wall, .kind = BodyKind::Static}));
    addLeaningBoxes(world);
    for (int step = 0; step < kSettling; ++step) world.step(kWallStep);
    return world;
}

void measureSteps(const BrickWall& wall) {
    World whole = leaningOn(wall.whole);
    World holed = leaningOn(wall.bricks.compound(wall.kept, wall.bricks.mass(wall.kept)));
    std::vector<double> wholeTimes, holedTimes;
    for (int step = 0; step < kSteps; ++step) {
        wholeTimes.push_back(millisecondsOf([&] { whole.step(kWallStep); }));
        holedTimes.push_back(millisecondsOf([&] { holed.step(kWallStep); }));
    }
    const double wholeTime = percentile(wholeTimes, 0.5), holedTime = percentile(holedTimes, 0.5);
    std::printf(
        "\n| a step with %d boxes on the wall | points | ms | ratio | at most |\n"
        "| --- | --- | --- | --- | --- |\n| whole | %d | %.4f | | |\n| with the hole | %d | %.4f | %.2f | 2 |\n",
        kLeaning, static_cast<int>(whole.counts().contactPoints), wholeTime,
        static_cast<int>(holed.counts().contactPoints), holedTime, holedTime / wholeTime);
}

}  // namespace

int main() {
    const BrickWall wall;
    measureSplits(wall);
    measureSteps(wall);
    return 0;
}
