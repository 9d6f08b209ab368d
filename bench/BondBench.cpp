// The time of a hit on structures of bonds: damage and islands, and what World::split() makes of them in a city.
//
//   BondBench
#include "bench/BondCases.h"
#include "bench/Bricks.h"
#include "bench/Timing.h"
#include "core/base/Percentile.h"
#include "core/structure/graph/Islands.h"

#include <cstdio>
#include <numeric>

using namespace rubble;
using namespace rubble::bench;

namespace {

constexpr int kRounds = 300;

struct CityTimes {
    std::vector<double> hits, splits;  // ms
    std::size_t bonds = 0, parts = 0;
};

/// The parts of the body of a structure: what is anchored stays, as one, and each other island falls.
std::vector<SplitPart> partsOf(const Bricks& bricks, const Islands& islands, const Shape& body,
                               std::span<const std::uint32_t> hullOf) {
    std::vector<std::uint32_t> held;
    std::vector<SplitPart> parts(1);
    for (std::uint32_t k = 0; k < islands.count(); ++k) {
        const Island island = islands[k];
        if (island.isAnchored)
            held.insert(held.end(), island.nodes.begin(), island.nodes.end());
        else
            parts.push_back(bricks.part(island.nodes, hullOf));
    }
    parts[0].kind = BodyKind::Static;
    for (const std::uint32_t brick : held) parts[0].hulls.push_back(hullOf[brick]);
    parts[0].shape = remainingShape(body, parts[0].hulls);
    return parts;
}

/// A hit on a structure that is one static body.
CityTimes timesOf(const BondCase& bonds) {
    const Bricks bricks(bonds.graph.centres, 1.0);
    std::vector<std::uint32_t> all(bricks.count());
    std::iota(all.begin(), all.end(), 0u);
    World world({.sleeping = false});
    const BodyId body = *world.addBody({.shape = bricks.compound(all, bricks.mass(all)), .kind = BodyKind::Static});
    world.step(kWallStep);
    const std::shared_ptr<const Snapshot> intact = world.snapshot();
    BondHits hits(bonds);
    CityTimes times;
    for (int round = 0; round < kRounds; ++round) {
        world.restore(*intact);
        times.hits.push_back(hits.round());
        std::vector<SplitPart> parts;
        const Islands islands = islandsOf(bonds.graph, hits.damage(), hits.nodes());
        times.splits.push_back(millisecondsOf([&] {
            parts = partsOf(bricks, islands, world.shape(body), all);
            static_cast<void>(*world.split(body, parts));
        }));
        times.parts = parts.size();
    }
    times.bonds = hits.broken();
    return times;
}

}  // namespace

int main() {
    std::printf(
        "| structure | nodes | bonds | broken | islands | damage and islands, ms |\n"
        "| --- | --- | --- | --- | --- | --- |\n");
    for (const BondCase& bonds : bondCases()) {
        BondHits hits(bonds);
        std::vector<double> times;
        for (int round = 0; round < kRounds; ++round) times.push_back(hits.round());
        std::printf("| %s | %u | %u | %zu | %zu | %.4f |\n", bonds.name.c_str(), bonds.graph.nodeCount(),
                    bonds.graph.bondCount(), hits.broken(), hits.islands(), percentile(times, 0.5));
    }
    std::printf(
        "\n| 36 towers | bodies | bonds broken | parts | damage and islands, ms | shapes and split, ms "
        "| together, ms | at most |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const auto& [name, bonds] : {std::pair("one graph", city()), std::pair("a graph each", towerOfCity())}) {
        const CityTimes times = timesOf(bonds);
        const double hit = percentile(times.hits, 0.5), split = percentile(times.splits, 0.5);
        std::printf("| %s | %s | %zu | %zu | %.4f | %.4f | %.4f | 0.7 |\n", name, bonds.name == "city" ? "1" : "36",
                    times.bonds, times.parts, hit, split, hit + split);
    }
    return 0;
}
