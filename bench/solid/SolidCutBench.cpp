// How long meshes take to be cut into Voronoi cells, compared with CGAL and, where it is installed, Manifold; how that
// grows with triangles and with cells; and the memory of a million triangles.
//
//   SolidCutBench
#include "bench/Timing.h"
#include "bench/solid/SolidPeers.h"
#include "core/fracture/solid/SolidCut.h"
#include "core/geometry/mesh/SolidMesh.h"
#include "tests/support/geometry/SolidShapes.h"

#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <tuple>

using namespace rubble;
using namespace rubble::bench;
using namespace rubble::test;

namespace {

constexpr double kVolumeTolerance = 1e-9;

struct SolidCase {
    const char* name;
    TriangleMesh mesh;
    int cells;
    int rounds;  // of ours and of Manifold; CGAL has one
    // Peers that would take minutes are left out.
    bool hasManifold = true;
    bool hasPlanes = false;  // of Manifold
    bool hasCgal = true;
};

/// The fastest of some runs.
struct Fastest {
    double milliseconds = std::numeric_limits<double>::infinity();
    void add(double time) { milliseconds = std::min(milliseconds, time); }
};

SolidPartition ours(const TriangleMesh& mesh, std::span<const Vec3> seeds, int threads) {
    TaskContext task;
    task.threads = threads;
    Result<SolidPartition> partition = cutSolid(mesh, seeds, task);
    if (partition) return std::move(*partition);
    std::fprintf(stderr, "SolidCutBench: %s\n", partition.error().message.c_str());
    std::exit(1);
}

void expectVolume(const TriangleMesh& mesh, double volume, const char* whose) {
    const double whole = signedVolume(mesh);
    if (std::abs(volume - whole) <= kVolumeTolerance * whole) return;
    std::fprintf(stderr, "The volumes of %s sum to %.17g instead of %.17g.\n", whose, volume, whole);
}

double volumeOf(const SolidPartition& partition) {
    double sum = 0.0;
    for (const double volume : partition.volumes) sum += volume;
    return sum;
}

std::string ratio(double slower, double faster) {
    if (!std::isfinite(slower)) return "";
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", slower / faster);
    return text;
}

std::string milliseconds(double time) {
    if (!std::isfinite(time)) return "";
    char text[32];
    std::snprintf(text, sizeof text, time < 100.0 ? "%.2f" : "%.0f", time);
    return text;
}

void measure(const SolidCase& solid) {
    const std::vector<Vec3> seeds = seedsInBox(solid.mesh, solid.cells, 7);
    const std::vector<ConvexCell> cells =
        solid.hasManifold || solid.hasCgal ? cellsAround(solid.mesh, seeds) : std::vector<ConvexCell>();
    Fastest one, two, cgal, manifold;
    std::uint32_t fragments = 0;
    const auto time = [&](Fastest& fastest, const char* name, const auto& cut) {
        CutSum sum;
        fastest.add(millisecondsOf([&] { sum = cut(); }));
        expectVolume(solid.mesh, sum.volume, name);
    };
    for (int round = 0; round < solid.rounds; ++round) {  // alternating, so that other load slows all
        SolidPartition partition;
        one.add(processorMillisecondsOf([&] { partition = ours(solid.mesh, seeds, 1); }));
        two.add(millisecondsOf([&] { partition = ours(solid.mesh, seeds, 2); }));
        fragments = partition.fragmentCount();
        expectVolume(solid.mesh, volumeOf(partition), "ours");
        if (hasManifold() && solid.hasManifold) {
            time(manifold, "Manifold", [&] { return intersectedByManifold(solid.mesh, cells, 1); });
            time(manifold, "Manifold", [&] { return intersectedByManifold(solid.mesh, cells, 2); });
            if (solid.hasPlanes)
                time(manifold, "Manifold's planes", [&] { return splitByManifold(solid.mesh, cells); });
        }
        if (round > 0 || !solid.hasCgal) continue;
        CutSum sum;
        cgal.add(processorMillisecondsOf([&] { sum = cutByCgal(solid.mesh, cells); }));
        expectVolume(solid.mesh, sum.volume, "CGAL");
    }
    std::printf("| %s | %zu | %d | %u | %s | %s | %s | %s | %s | %s | %s |\n", solid.name, solid.mesh.triangles.size(),
                solid.cells, fragments, milliseconds(one.milliseconds).c_str(), milliseconds(two.milliseconds).c_str(),
                milliseconds(manifold.milliseconds).c_str(), milliseconds(cgal.milliseconds).c_str(),
                ratio(one.milliseconds, two.milliseconds).c_str(),
                ratio(manifold.milliseconds, one.milliseconds).c_str(),
                ratio(cgal.milliseconds, one.milliseconds).c_str());
    std::fflush(stdout);
}

void measureMemory() {
    const TriangleMesh mesh = bumpySphere(708);
    const std::vector<Vec3> seeds = seedsInBox(mesh, 1000, 7);
    rusage before{}, after{};
    getrusage(RUSAGE_SELF, &before);
    const double wall = millisecondsOf([&] { static_cast<void>(ours(mesh, seeds, 1)); });
    getrusage(RUSAGE_SELF, &after);
    std::printf(
        "%zu triangles, 1000 cells: %.2f s (at most 4), %.0f MiB at their peak, %.0f of these for the cut (at "
        "most 2048).\n\n",
        mesh.triangles.size(), wall / 1000.0, static_cast<double>(after.ru_maxrss) / 1024.0,
        static_cast<double>(after.ru_maxrss - before.ru_maxrss) / 1024.0);
}

double fastestOf(const TriangleMesh& mesh, int cells, int rounds) {
    const std::vector<Vec3> seeds = seedsInBox(mesh, cells, 7);
    Fastest fastest;
    for (int round = 0; round < rounds; ++round) {
        fastest.add(processorMillisecondsOf([&] { static_cast<void>(ours(mesh, seeds, 1)); }));
    }
    return fastest.milliseconds;
}

void printGrowth(const char* name, const std::array<double, 3>& times) {
    const auto exponent = [&](std::size_t k) { return std::log(times[k + 1] / times[k]) / std::log(4.0); };
    std::printf("| %s | %s | %s | %s | %.2f | %.2f |\n", name, milliseconds(times[0]).c_str(),
                milliseconds(times[1]).c_str(), milliseconds(times[2]).c_str(), exponent(0), exponent(1));
}

}  // namespace

int main() {
    measureMemory();
    if (!hasManifold()) std::printf("Manifold is absent: the columns of it are empty.\n\n");
    std::printf(
        "| mesh | triangles | cells | fragments | ours, ms | ours on 2 threads, ms | Manifold, ms | CGAL, ms | "
        "ours : ours on 2 threads | Manifold : ours | CGAL : ours |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
    measure({.name = "bumpy sphere", .mesh = bumpySphere(72), .cells = 100, .rounds = 15, .hasPlanes = true});
    measure({.name = "bumpy sphere", .mesh = bumpySphere(72), .cells = 1000, .rounds = 9});
    measure({.name = "torus", .mesh = torus(100, 50), .cells = 100, .rounds = 15, .hasPlanes = true});
    measure({.name = "torus", .mesh = torus(100, 50), .cells = 1000, .rounds = 9});
    measure({.name = "bumpy sphere", .mesh = bumpySphere(224), .cells = 1000, .rounds = 3, .hasCgal = false});
    measure({.name = "bumpy sphere",
             .mesh = bumpySphere(708),
             .cells = 1000,
             .rounds = 3,
             .hasManifold = false,
             .hasCgal = false});
    measure({.name = "Menger sponge", .mesh = mengerSponge(4), .cells = 100, .rounds = 2, .hasCgal = false});
    std::printf(
        "\n| growth | n, ms | 4n, ms | 16n, ms | exponent n-4n | 4n-16n |\n| --- | --- | --- | --- | --- | --- |\n");
    printGrowth("10,224 triangles, 1,000 cells: triangles",
                {fastestOf(bumpySphere(72), 1000, 9), fastestOf(bumpySphere(144), 1000, 5),
                 fastestOf(bumpySphere(287), 1000, 3)});
    printGrowth("10,224 triangles, 1,000 cells: cells",
                {fastestOf(bumpySphere(72), 1000, 9), fastestOf(bumpySphere(72), 4000, 5),
                 fastestOf(bumpySphere(72), 16'000, 3)});
    return 0;
}
