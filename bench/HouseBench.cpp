// The time of steps in which a house of two storeys and 10,000 bonded fragments is shot at: 200 balls from all around,
// ten a second, on one thread, in time of the processor. Every round plays the same; of each step the fastest round
// counts.
//
//   HouseBench [ROUNDS]
#include "bench/Timing.h"
#include "core/base/Percentile.h"
#include "core/base/Random.h"
#include "core/play/session/Session.h"
#include "tests/support/asset/TwoStoreyHouse.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace rubble;

namespace {

constexpr double kDensity = 39.5;  // fragments per m²: 10,000 in all
constexpr int kShots = 200;
constexpr int kInterval = 30;                 // steps from shot to shot
constexpr int kAfter = 300;                   // steps after the last
constexpr double kStepLimit = 1000.0 / 60.0;  // ms

/// A ball from a random direction, not from below, at a random point of the house.
Throw randomThrow(Random& random) {
    constexpr double kDistance = 15.0;  // m
    const Vec3 to{random.between(-4.0, 4.0), random.between(0.3, 7.0), random.between(-3.0, 3.0)};
    Vec3 direction;
    do {
        direction = {random.between(-1.0, 1.0), random.between(-0.05, 0.7), random.between(-1.0, 1.0)};
    } while (glm::length(direction) > 1.0 || glm::length(direction) < 0.2);
    Vec3 from = to + kDistance * glm::normalize(direction);
    from.y = std::max(from.y, 0.5);
    return {.kind = ProjectileKind::Ball,
            .size = Vec3(random.between(0.15, 0.35)),
            .mass = random.between(10.0, 50.0),
            .from = from,
            .to = to,
            .speed = random.between(15.0, 35.0)};
}

struct Played {
    std::vector<double> times;  // ms, of each step
    Session session;
};

Played played(const std::shared_ptr<const PlayScene>& scene) {
    constexpr std::uint64_t kSeed = 2;
    Random random(kSeed);
    Played one{{}, std::move(*Session::start(scene))};
    for (int shot = 0; shot < kShots; ++shot) {
        const auto step = static_cast<std::uint64_t>(shot * kInterval);
        static_cast<void>(one.session.add(TimedInput{step, ShotInput{"ball", randomThrow(random)}}));
    }
    for (int step = 0; step < kShots * kInterval + kAfter; ++step)
        one.times.push_back(bench::processorMillisecondsOf([&] { one.session.step(); }));
    return one;
}

std::size_t heldFragments(const Session& session) {
    std::size_t count = 0;
    for (const PlayBody& body : session.bodies()) count += body.isHeld ? bondedFragments(body).size() : 0;
    return count;
}

void print(const PlayScene& scene, const Played& one, double starting) {
    std::size_t fragments = 0, bonds = 0;
    for (const auto& [instance, structure] : scene.structures) {
        fragments += structure->nodeCount();
        bonds += structure->graph.bondCount();
    }
    const auto slow = std::ranges::count_if(one.times, [](double time) { return time > kStepLimit; });
    std::printf(
        "| fragments | bonds | start, ms | steps | median, ms | p90 | p99 | max | steps above 16.7 ms |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n"
        "| %zu | %zu | %.0f | %zu | %.2f | %.2f | %.2f | %.2f | %d |\n",
        fragments, bonds, starting, one.times.size(), percentile(one.times, 0.5), percentile(one.times, 0.9),
        percentile(one.times, 0.99), percentile(one.times, 1.0), static_cast<int>(slow));
    std::printf("\nAfter them %zu fragments are held, in %zu bodies; hash %s.\n", heldFragments(one.session),
                one.session.bodies().size(), one.session.hash().hex().c_str());
    std::vector<std::size_t> slowest(one.times.size());
    for (std::size_t k = 0; k < slowest.size(); ++k) slowest[k] = k;
    std::ranges::sort(slowest, [&](std::size_t a, std::size_t b) { return one.times[a] > one.times[b]; });
    std::printf("The slowest steps:");
    for (std::size_t k = 0; k < 12; ++k) std::printf(" %zu: %.1f ms", slowest[k] + 1, one.times[slowest[k]]);
    std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 3;
    std::shared_ptr<const PlayScene> scene;
    const double starting = bench::processorMillisecondsOf([&] { scene = *playScene(test::twoStoreyHouse(kDensity)); });
    Played one = played(scene);
    for (int round = 1; round < rounds; ++round) {
        const Played again = played(scene);
        for (std::size_t k = 0; k < one.times.size(); ++k) one.times[k] = std::min(one.times[k], again.times[k]);
    }
    print(*scene, one, starting);
    return 0;
}
