// The time of steps in which something breaks: walls of bonds in a blast, one hit at a large wall, a city, a street
// under fire, and houses joined by mortar of which the middle one, or each, is blown up. On one thread, in time of the
// processor; every round plays the same, and of each step the fastest round counts.
//
//   SessionBench [SCENE...]   such as wall-10000, hit-30000, city-36, street-30, terrace-40; without arguments all
#include "bench/Timing.h"
#include "bench/session/HouseRows.h"
#include "core/base/Percentile.h"
#include "core/base/Random.h"
#include "core/play/session/Session.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace rubble;
using namespace rubble::bench;

namespace {

constexpr int kRounds = 2;
constexpr std::uint64_t kHitStep = 30;

struct BenchScene {
    Project project;
    std::vector<TimedInput> inputs;
    int steps = 0;
};

/// A bonded prism that stands on the ground, and is anchored there.
Id addBonded(Project& project, Vec2 size, double depth, std::uint32_t fragments, double impulsePerArea) {
    const Id stone = test::addMaterial(project, {.name = "stone", .density = 2000.0});
    const Id wall = test::addAsset(
        project,
        {.name = "wall",
         .material = stone,
         .shape = Prism{{rectangle({-size.x / 2.0, -size.y / 2.0}, {size.x / 2.0, size.y / 2.0}), {}}, depth}},
        {UniformScatter{.count = fragments}});
    project.assets.back().breakAs = BreakAs::Bonded;
    project.assets.back().bonding.impulsePerArea = impulsePerArea;
    project.assets.back().bonding.minimumIsland = 2;
    return wall;
}

void addStanding(Project& project, Id asset, double height, Vec3 at) {
    test::addInstance(project, asset, "wall " + std::to_string(project.instances.size()),
                      {.position = {at.x, height / 2.0, at.z}});
    project.instances.back().isAnchored = true;
}

Throw ball(Vec3 from, Vec3 to, double mass, double speed) {
    return {.kind = ProjectileKind::Ball, .size = Vec3(0.3), .mass = mass, .from = from, .to = to, .speed = speed};
}

void shoot(BenchScene& scene, std::uint64_t step, const ShotAction& action) {
    TimedInput shot;
    shot.step = step;
    shot.input = ShotInput{"shot", action};
    scene.inputs.push_back(std::move(shot));
}

/// A wall of 12 by 4 m, and a blast of 30,000 N·s before its middle.
BenchScene blownWall(std::uint32_t fragments) {
    BenchScene scene{.steps = 150};
    addStanding(scene.project, addBonded(scene.project, {12.0, 4.0}, 0.5, fragments, 100.0), 4.0, {});
    shoot(scene, kHitStep, Blast{.at = {0.0, 2.0, 1.0}, .impulse = 30000.0, .radius = 3.5});
    return scene;
}

/// The same wall, and one ball that frees some of it.
BenchScene hitWall(std::uint32_t fragments) {
    BenchScene scene{.steps = 60};
    addStanding(scene.project, addBonded(scene.project, {12.0, 4.0}, 0.5, fragments, 100.0), 4.0, {});
    shoot(scene, kHitStep, ball({0.0, 2.0, 3.0}, {0.0, 2.0, 0.0}, 60.0, 25.0));
    return scene;
}

/// Towers of four walls each in a square, of 256 fragments each, and one ball at one of them.
BenchScene city(int towers) {
    BenchScene scene{.steps = 60};
    const Id asset = addBonded(scene.project, {2.0, 8.0}, 2.0, 256, 100.0);
    const int side = static_cast<int>(std::ceil(std::sqrt(towers)));
    for (int k = 0; k < towers; ++k) addStanding(scene.project, asset, 8.0, {4.0 * (k % side), 0.0, -4.0 * (k / side)});
    shoot(scene, kHitStep, ball({0.0, 4.0, 5.0}, {0.0, 4.0, 0.0}, 60.0, 25.0));
    return scene;
}

/// A row of towers under a ball every quarter of a second.
BenchScene street(int towers) {
    BenchScene scene{.steps = 1200};
    const Id asset = addBonded(scene.project, {2.0, 8.0}, 0.6, 250, 150.0);
    for (int k = 0; k < towers; ++k) addStanding(scene.project, asset, 8.0, {3.0 * k, 0.0, 0.0});
    Random random(7);
    for (std::uint64_t step = kHitStep; step < 1000; step += 15) {
        const Vec3 to{random.between(-1.0, 3.0 * towers - 2.0), random.between(0.5, 7.5), 0.0};
        const Vec3 from = to + Vec3(random.between(-3.0, 3.0), 1.0, 8.0);
        const double mass = random.between(20.0, 120.0), speed = random.between(15.0, 30.0);
        shoot(scene, step, ball(from, to, mass, speed));
    }
    return scene;
}

BenchScene sceneOf(HouseRow row) {
    return {.project = std::move(row.project), .inputs = std::move(row.inputs), .steps = 240};
}

/// Houses apart, and a blast in the middle one.
BenchScene houses(int count) {
    HouseRow row = rowOfHouses(count);
    blowUp(row, kHitStep);
    return sceneOf(std::move(row));
}

/// Houses whose walls mortar joins with those of the next one, and a blast in the middle one.
BenchScene terrace(int count) {
    HouseRow row = rowOfHouses(count, 2.0 * test::kHouseHalfWidth);
    blowUp(row, kHitStep);
    return sceneOf(std::move(row));
}

BenchScene sceneOf(const std::string& name) {
    const int count = std::atoi(name.substr(name.find('-') + 1).c_str());
    if (name.starts_with("wall-")) return blownWall(static_cast<std::uint32_t>(count));
    if (name.starts_with("hit-")) return hitWall(static_cast<std::uint32_t>(count));
    if (name.starts_with("city-")) return city(count);
    if (name.starts_with("street-")) return street(count);
    if (name.starts_with("houses-")) return houses(count);
    if (name.starts_with("terrace-")) return terrace(count);
    if (name.starts_with("collapse-")) return sceneOf(blownUpHouses(count, kHitStep));
    std::fprintf(stderr, "There is no scene \"%s\".\n", name.c_str());
    std::exit(1);
}

struct Played {
    std::vector<double> times;  // ms, of each step
    std::size_t dynamic = 0;    // bodies, at the end
    ContentHash hash;           // of the world, at the end
};

Played played(const BenchScene& bench, const std::shared_ptr<const PlayScene>& scene) {
    Session session = std::move(*Session::start(scene));
    for (const TimedInput& input : bench.inputs) static_cast<void>(session.add(input));
    Played one;
    for (int step = 0; step < bench.steps; ++step)
        one.times.push_back(bench::processorMillisecondsOf([&] { session.step(); }));
    one.dynamic = static_cast<std::size_t>(std::ranges::count_if(
        session.bodies(), [&](const PlayBody& body) { return session.world().kind(body.body) == BodyKind::Dynamic; }));
    one.hash = session.world().hash();
    return one;
}

void measure(const std::string& name) {
    const BenchScene bench = sceneOf(name);
    std::shared_ptr<const PlayScene> scene;
    const double starting = bench::processorMillisecondsOf([&] { scene = *playScene(bench.project); });
    Played one = played(bench, scene);
    for (int round = 1; round < kRounds; ++round) {
        const Played again = played(bench, scene);
        for (std::size_t k = 0; k < one.times.size(); ++k) one.times[k] = std::min(one.times[k], again.times[k]);
    }
    const auto hit = one.times.begin() + static_cast<std::ptrdiff_t>(kHitStep);
    std::printf("| %s | %zu | %.0f | %.2f | %.2f | %.2f | %.2f | %zu | %.8s |\n", name.c_str(), one.dynamic, starting,
                percentile(one.times, 0.5), percentile(one.times, 0.99), *hit, percentile(one.times, 1.0),
                static_cast<std::size_t>(std::ranges::max_element(one.times) - one.times.begin()),
                one.hash.hex().c_str());
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> names(argv + 1, argv + argc);
    if (names.empty())
        names = {"wall-2500", "wall-10000", "wall-30000", "hit-30000",  "city-36",     "street-30",  "houses-1",
                 "houses-40", "houses-160", "terrace-10", "terrace-40", "terrace-160", "collapse-10"};
    std::printf(
        "| scene | free bodies | start, ms | median, ms | p99 | at the hit | max | at step | state |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const std::string& name : names) measure(name);
    return 0;
}
