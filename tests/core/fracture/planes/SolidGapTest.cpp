// Tests core/fracture/planes/SolidGap.cpp and core/fracture/planes/ContactPlanes.cpp.
#include "core/fracture/planes/SolidGap.h"

#include "core/base/Stopwatch.h"
#include "core/fracture/planes/SolidSplit.h"
#include "core/fracture/solid/SolidContacts.h"
#include "core/fracture/solid/SolidCut.h"
#include "core/fracture/solid/SolidMerge.h"
#include "core/geometry/mesh/SolidMesh.h"
#include "core/geometry/predicates/SegmentDistance.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/SolidCells.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>

using namespace rubble;
using namespace rubble::test;

namespace {

/// A cube of size 1 cut into n³ cubes.
SolidPartition cubeGrid(int n) {
    std::vector<Vec3> seeds;
    for (int k = 0; k < n * n * n; ++k) seeds.push_back((Vec3(k % n, k / n % n, k / n / n) + 0.5) / double(n));
    return cellsOf(cubes({{0, 0, 0}}), seeds);
}

/// What is wrong with a shrunk fragment.
std::string gapFault(const SolidPartition& partition, std::uint32_t fragment, const ShrunkFragment& left, double gap) {
    const TriangleMesh& mesh = left.mesh;
    if (left.sides.size() != mesh.triangles.size()) return "Not each triangle has a side.";
    std::map<std::array<std::uint32_t, 2>, int> edges;
    for (const std::array<std::uint32_t, 3>& t : mesh.triangles) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    }
    if (std::ranges::any_of(edges, [](const auto& edge) { return edge.second != 0; })) return "The mesh is open.";
    if (mesh.triangles.empty()) return left.volume == 0.0 ? "" : "Nothing has a volume.";
    if (std::abs(left.volume - signedVolume(mesh)) > 1e-12) return "The volume is not that of the mesh.";
    if (!(left.volume > 0.0) || left.volume > partition.volumes[fragment] + 1e-12) return "The volume is out of range.";
    for (const ShrunkFragment::Side& side : left.sides) {
        if ((side.neighbour == kNone) == (side.source == kNone)) return "A triangle is neither inner nor outer.";
    }
    std::vector<Vec3> corners;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (glm::length(doubleArea(mesh, t)) < 1e-10) continue;  // rounding leaves triangles without area
        for (const std::uint32_t point : mesh.triangles[t]) corners.push_back(mesh.points[point]);
    }
    for (const SolidPartition::FaceSide& side : partition.facesOf(fragment)) {
        if (partition.faces[side.face].behind == kNone) continue;
        for (const auto& [a, b, c] : partition.trianglesOf(side.face)) {
            const std::vector<Vec3>& p = partition.points;
            for (const Vec3 point : corners) {
                if (distanceToTriangle(point, p[a], p[b], p[c]) < gap / 2.0 - 1e-9) return "A point is in the gap.";
            }
        }
    }
    return {};
}

std::string gapFault(const SolidPartition& partition, double gap) {
    const Result<ShrunkSolid> shrunk = shrunkFragments(partition, gap);
    if (!shrunk) return shrunk.error().message;
    for (std::uint32_t k = 0; k < partition.fragmentCount(); ++k) {
        const std::string fault = gapFault(partition, k, shrunk->fragments[k], gap);
        if (!fault.empty()) return "Fragment " + std::to_string(k) + ": " + fault;
    }
    return {};
}

double sumOfVolumes(const ShrunkSolid& solid) {
    double sum = 0.0;
    for (const ShrunkFragment& fragment : solid.fragments) sum += fragment.volume;
    return sum;
}

}  // namespace

class SolidGapTest : public QObject {
    Q_OBJECT
private slots:
    void cubesLoseTheirInnerSides() {
        const SolidPartition grid = cubeGrid(3);
        QCOMPARE(grid.fragmentCount(), 27u);
        const double gap = 0.1, width = 1.0 / 3.0;
        const Result<ShrunkSolid> shrunk = shrunkFragments(grid, gap);
        QVERIFY(shrunk && shrunk->diagnostics.empty());
        for (std::uint32_t k = 0; k < 27; ++k) {
            double volume = 1.0;
            for (const std::uint32_t place : {k % 3, k / 3 % 3, k / 9})
                volume *= width - (place == 1 ? gap : gap / 2.0);
            const ShrunkFragment& left = shrunk->fragments[grid.fragmentOfSeed[k]];
            QVERIFY(std::abs(left.volume - volume) < 1e-15);
            QCOMPARE(gapFault(grid, grid.fragmentOfSeed[k], left, gap), std::string());
            for (std::size_t t = 0; t < left.sides.size(); ++t) {
                if (left.sides[t].neighbour != kNone) continue;
                const Vec3 normal = doubleArea(left.mesh, t);  // of the cube's side
                const Vec3 corner = grid.origin + left.mesh.points[left.mesh.triangles[t][0]];
                const int axis = std::abs(normal.x) > 1e-9 ? 0 : std::abs(normal.y) > 1e-9 ? 1 : 2;
                QVERIFY(std::abs(corner[axis] - (normal[axis] > 0.0 ? 1.0 : 0.0)) < 1e-15);
            }
        }
    }
    void noGapChangesNothing() {
        const TriangleMesh mesh = bumpySphere(16);
        const SolidPartition partition = cellsOf(mesh, seedsInBox(mesh, 30, 1));
        const Result<ShrunkSolid> shrunk = shrunkFragments(partition, 0.0);
        QVERIFY(shrunk && shrunk->diagnostics.empty());
        for (std::uint32_t k = 0; k < partition.fragmentCount(); ++k) {
            QVERIFY(std::abs(shrunk->fragments[k].volume - partition.volumes[k]) < 1e-14);
        }
        QCOMPARE(gapFault(partition, 0.0), std::string());
    }
    void narrowFragmentsVanish() {
        const SolidPartition grid = cubeGrid(3);
        const Result<ShrunkSolid> shrunk = shrunkFragments(grid, 0.35);
        QVERIFY(shrunk);
        const auto isGone = [](const ShrunkFragment& left) { return left.mesh.triangles.empty(); };
        QCOMPARE(std::ranges::count_if(shrunk->fragments, isGone), 27 - 8);
        QCOMPARE(shrunk->diagnostics.size(), 19u);
        QCOMPARE(shrunk->diagnostics[0].code, DiagnosticCode::VanishedPiece);
        QCOMPARE(shrunk->diagnostics[0].place.seed, 1u);
        QVERIFY(std::abs(shrunk->diagnostics[0].value - 1.0 / 27.0) < 1e-15);
        QCOMPARE(shrunkFragments(grid, 10.0)->diagnostics.size(), 27u);
    }
    /// For small gaps, what is lost is half the gap times the area of the contacts.
    void smallGapsLoseTheAreaOfContacts() {
        for (const TriangleMesh& mesh : {bumpySphere(24), torus(40, 16), mengerSponge(1)}) {
            const SolidPartition partition = cellsOf(mesh, seedsInBox(mesh, 40, 2));
            double area = 0.0, whole = 0.0;
            for (const SolidContact& contact : contactsOf(partition)) area += contact.area;
            for (const double volume : partition.volumes) whole += volume;
            const double gap = 1e-6;
            const double lost = whole - sumOfVolumes(*shrunkFragments(partition, gap));
            QVERIFY2(std::abs(lost / (gap * area) - 1.0) < 1e-3, qPrintable(QString::number(lost / (gap * area))));
        }
    }
    void randomCellsShrink() {
        const std::vector<TriangleMesh> shapes = {bumpySphere(12), torus(20, 8), mengerSponge(1)};
        for (std::size_t shape = 0; shape < shapes.size(); ++shape) {
            for (int round = 0; round < 10; ++round) {
                const std::uint64_t seed = 100 * shape + static_cast<std::uint64_t>(round);
                const SolidPartition partition = cellsOf(shapes[shape], seedsInBox(shapes[shape], 20, seed));
                const std::string fault = gapFault(partition, 0.01 * (1 + round * round));
                QVERIFY2(fault.empty(), qPrintable(QString("%1, seed %2: ").arg(shape).arg(seed) + fault.c_str()));
            }
        }
    }
    /// RUBBLE_LONG: 5,000 meshes, else 500.
    void everythingTiesOnASmallLattice() {
        const int wanted = qEnvironmentVariableIsSet("RUBBLE_LONG") ? 5'000 : 500;
        int cut = 0;
        for (std::uint64_t seed = 0; cut < wanted; ++seed) {
            Random random(seed);
            const TriangleMesh mesh = randomLatticeMesh(random, seed % 2 == 1);
            if (mesh.triangles.empty()) continue;
            std::vector<Vec3> seeds(2 + random.below(7));
            for (Vec3& point : seeds) {
                const double x = static_cast<double>(random.below(5)), y = static_cast<double>(random.below(5));
                point = 0.5 * Vec3(x, y, static_cast<double>(random.below(5)));
            }
            SolidPartition partition = cellsOf(mesh, seeds);
            if (seed % 3 == 2) partition = withoutSmallFragments(std::move(partition), 0.2);
            const double gap = random.below(2) == 0 ? 0.125 : random.between(0.0, 0.3);
            const std::string fault = gapFault(partition, gap);
            QVERIFY2(fault.empty(), qPrintable(QString("seed %1: ").arg(seed) + fault.c_str()));
            ++cut;
        }
    }
    void mergedFragmentsShrinkAlongTheirFaces() {
        const TriangleMesh block = cubes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
        const SolidPartition four =
            cellsOf(block, {{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}, {0.5, 1.5, 0.5}, {1.5, 1.5, 0.5}});
        const SolidPartition shapeL = mergedFragments(four, std::vector<std::uint32_t>{0, 0, 0, 3});
        const double gap = 0.2, margin = gap / 2.0;
        const Result<ShrunkSolid> shrunk = shrunkFragments(shapeL, gap);
        QVERIFY(shrunk);
        QVERIFY(std::abs(shrunk->fragments[0].volume - (3.0 - 2.0 * margin - margin * margin)) < 1e-12);
        QVERIFY(std::abs(shrunk->fragments[1].volume - (1.0 - margin) * (1.0 - margin)) < 1e-12);
        QCOMPARE(gapFault(shapeL, gap), std::string());
    }
    /// RUBBLE_LONG: 12 partitions, else 2.
    void randomMergedAndSplitFragmentsShrink() {
        const std::uint64_t rounds = qEnvironmentVariableIsSet("RUBBLE_LONG") ? 12 : 2;
        const TriangleMesh mesh = bumpySphere(8);
        Random random(7);
        for (std::uint64_t seed = 0; seed < rounds; ++seed) {
            SolidPartition partition = withoutSmallFragments(cellsOf(mesh, seedsInBox(mesh, 20, seed)), 0.15);
            for (int k = 0; k < 3; ++k) {
                const Vec3 normal(random.between(-1, 1), random.between(-1, 1), 1.0);
                const std::uint32_t fragment = static_cast<std::uint32_t>(random.below(partition.fragmentCount()));
                const std::uint32_t face = partition.facesOf(fragment)[0].face;
                const Vec3 corner = partition.origin + partition.points[partition.trianglesOf(face)[0][0]];
                partition = splitFragment(std::move(partition), fragment, planeThrough(corner, normal))->partition;
            }
            const std::string fault = gapFault(partition, 0.03);
            QVERIFY2(fault.empty(), qPrintable(QString("seed %1: ").arg(seed) + fault.c_str()));
        }
    }
    void whatFallsApartKeepsItsLargestPart() {
        // Two blocks joined by a bar, and a cell that takes a part of the bar.
        const TriangleMesh bar = cubes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 1, 0}, {3, 1, 0}, {0, 2, 0}});
        const SolidPartition partition = cellsOf(bar, {{2.0, 0.9, 0.5}, {2.0, -0.4, 0.5}});
        QCOMPARE(partition.fragmentCount(), 2u);
        const Result<ShrunkSolid> shrunk = shrunkFragments(partition, 1.6);
        QVERIFY(shrunk);
        QVERIFY(shrunk->fragments[0].isDisconnected);
        QVERIFY(std::abs(shrunk->fragments[0].volume - 1.95) < 1e-12);
        QCOMPARE(gapFault(partition, 1.6), std::string());
    }
    void sameBitsOnAnyThreads() {
        const TriangleMesh mesh = bumpySphere(30);
        const SolidPartition partition = withoutSmallFragments(cellsOf(mesh, seedsInBox(mesh, 80, 5)), 0.01);
        const Result<ShrunkSolid> first = shrunkFragments(partition, 0.02);
        QVERIFY(first);
        for (const int threads : {2, 8}) {
            TaskContext task;
            task.threads = threads;
            const Result<ShrunkSolid> other = shrunkFragments(partition, 0.02, task);
            QVERIFY(other);
            for (std::size_t k = 0; k < first->fragments.size(); ++k) {
                const auto &a = first->fragments[k].mesh, &b = other->fragments[k].mesh;
                QVERIFY(a.points.size() == b.points.size() && a.triangles == b.triangles);
                QVERIFY(std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(Vec3)) == 0);
            }
            QCOMPARE(other->diagnostics, first->diagnostics);
        }
    }
    void badInputIsRefused() {
        const SolidPartition grid = cubeGrid(2);
        QCOMPARE(shrunkFragments(grid, -0.1).error().code, ErrorCode::BadInput);
        QCOMPARE(shrunkFragments(grid, std::numeric_limits<double>::quiet_NaN()).error().code, ErrorCode::BadInput);
        TaskContext task;
        task.cancel.cancel();
        QCOMPARE(shrunkFragments(grid, 0.1, task).error().code, ErrorCode::Cancelled);
    }
    void aThousandCellsShrinkFast() {
        const TriangleMesh mesh = bumpySphere(224);  // 100,000 triangles
        const SolidPartition partition = cellsOf(mesh, seedsInBox(mesh, 1000, 6));
        Stopwatch watch;
        QVERIFY(shrunkFragments(partition, 0.01));
        const double taken = watch.lap();
        qInfo("%u fragments: %.0f ms", partition.fragmentCount(), taken);
        QVERIFY(taken < 10'000.0);
    }
};

RUBBLE_TEST(SolidGapTest)
#include "SolidGapTest.moc"
