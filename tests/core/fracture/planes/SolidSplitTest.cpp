// Tests core/fracture/planes/SolidSplit.cpp and core/fracture/planes/PlaneCut.cpp.
#include "core/fracture/planes/SolidSplit.h"

#include "core/base/Stopwatch.h"
#include "core/fracture/solid/SolidContacts.h"
#include "core/fracture/solid/SolidCut.h"
#include "core/fracture/solid/SolidMerge.h"
#include "core/fracture/verify/VerifySolidPartition.h"
#include "core/geometry/mesh/SolidMesh.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/SolidCells.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>

using namespace rubble;
using namespace rubble::test;

namespace {

Vec3 anyPoint(Random& random, const SolidPartition& partition) {
    return partition.origin + partition.points[random.below(partition.points.size())];
}

Vec3 anyDirection(Random& random) {
    const double x = random.between(-1, 1), y = random.between(-1, 1);
    return Vec3(x, y, random.between(-1, 1) + 2.0);
}

/// A point of 0, 1/2, ..., 2 in each coordinate.
Vec3 latticePoint(Random& random) {
    const double x = static_cast<double>(random.below(5)), y = static_cast<double>(random.below(5));
    return 0.5 * Vec3(x, y, static_cast<double>(random.below(5)));
}

/// What is wrong with a split; `mesh` and `seeds` are what was cut at first.
std::string splitFault(const SolidPartition& before, std::uint32_t fragment, const SolidSplit& split,
                       const TriangleMesh& mesh, const std::vector<Vec3>& seeds) {
    if (const auto fault = verifySolidPartition(split.partition, mesh, seeds)) return *fault;
    double sum = 0.0;
    for (const std::uint32_t piece : split.pieces) {
        sum += split.partition.volumes[piece];
        if (split.partition.seedOfFragment[piece] != before.seedOfFragment[fragment])
            return "A piece has another seed.";
    }
    if (std::abs(sum - before.volumes[fragment]) > 1e-12 * signedVolume(mesh)) return "The volume changed.";
    if (split.numbers[fragment] != split.pieces[0]) return "The first piece is not the fragment.";
    for (std::uint32_t k = 0; k < before.fragmentCount(); ++k) {
        const std::uint32_t now = split.numbers[k];
        if (before.seedOfFragment[k] != split.partition.seedOfFragment[now]) return "A fragment has another seed.";
        if (k == fragment) continue;
        if (before.partOfFragment[k] != split.partition.partOfFragment[now])
            return "A fragment has another part number.";
        if (std::abs(before.volumes[k] - split.partition.volumes[now]) > 1e-13 * signedVolume(mesh)) {
            return "The volume of another fragment changed.";
        }
    }
    return {};
}

double heightOf(const SolidPartition& partition, std::uint32_t fragment, const SectionPlane& plane, bool isHighest) {
    double height = isHighest ? -1e9 : 1e9;
    for (const SolidPartition::FaceSide& side : partition.facesOf(fragment)) {
        for (const auto& triangle : partition.trianglesOf(side.face)) {
            for (const std::uint32_t point : triangle) {
                const double other = plane.heightOf(partition.origin + partition.points[point]);
                height = isHighest ? std::max(height, other) : std::min(height, other);
            }
        }
    }
    return height;
}

/// Whether each piece is on one side of the plane.
bool areOnOneSide(const SolidSplit& split, const SectionPlane& plane, double tolerance) {
    return std::ranges::all_of(split.pieces, [&](std::uint32_t piece) {
        return heightOf(split.partition, piece, plane, true) < tolerance ||
               heightOf(split.partition, piece, plane, false) > -tolerance;
    });
}

/// Splits fragments of random meshes on a lattice, where everything ties, by planes through its points; what is wrong
/// with a result, and where. RUBBLE_LONG: 30,000 cases, else 2,000.
QString latticeFault(const Mat3& matrix, Vec3 offset) {
    const int wanted = qEnvironmentVariableIsSet("RUBBLE_LONG") ? 30'000 : 2'000;
    int splits = 0, cut = 0;
    for (std::uint64_t seed = 0; splits < wanted; ++seed) {
        Random random(seed);
        const TriangleMesh straight = randomLatticeMesh(random, seed % 2 == 1);
        if (straight.triangles.empty()) continue;
        const TriangleMesh mesh = transformed(straight, matrix, offset);
        std::vector<Vec3> seeds(1 + random.below(8));
        for (Vec3& point : seeds) point = matrix * latticePoint(random) + offset;
        SolidPartition partition = cellsOf(mesh, seeds);
        for (int k = 0; k < 6; ++k, ++splits) {
            const QString place = QString("seed %1, split %2: ").arg(seed).arg(k);
            if (partition.fragmentCount() == 0) return place + "no fragments";
            const std::uint32_t fragment = static_cast<std::uint32_t>(random.below(partition.fragmentCount()));
            const Vec3 direction = 2.0 * latticePoint(random) - Vec3(2.0, 2.0, 1.0);
            if (direction == Vec3(0.0)) continue;
            const SectionPlane flat = planeThrough(Vec3(0.0), direction);
            const Vec3 point =
                random.below(2) == 0 ? matrix * latticePoint(random) + offset : anyPoint(random, partition);
            const SectionPlane plane = planeThrough(point, glm::cross(matrix * flat.x, matrix * flat.y));
            Result<SolidSplit> split = splitFragment(partition, fragment, plane);
            if (!split) return place + split.error().message.c_str();
            const std::string fault = splitFault(partition, fragment, *split, mesh, seeds);
            if (!fault.empty()) return place + fault.c_str();
            if (!areOnOneSide(*split, plane, 1e-9)) return place + "A piece is on both sides.";
            cut += split->pieces.size() > 1;
            partition = std::move(split->partition);
        }
    }
    return cut > wanted / 4 ? QString() : QString("Only %1 were split.").arg(cut);
}

const std::vector<Vec3> kEightSeeds = {{0.25, 0.25, 0.25}, {0.75, 0.25, 0.25}, {0.25, 0.75, 0.25}, {0.75, 0.75, 0.25},
                                       {0.25, 0.25, 0.75}, {0.75, 0.25, 0.75}, {0.25, 0.75, 0.75}, {0.75, 0.75, 0.75}};

}  // namespace

class SolidSplitTest : public QObject {
    Q_OBJECT
private slots:
    void aCubeletIsHalved() {
        const TriangleMesh cube = cubes({{0, 0, 0}});
        const SolidPartition eight = cellsOf(cube, kEightSeeds);
        QCOMPARE(eight.fragmentCount(), 8u);
        const Result<SolidSplit> split = splitFragment(eight, 3, axisPlane(2, 0.125));
        QVERIFY(split);
        QCOMPARE(splitFault(eight, 3, *split, cube, kEightSeeds), std::string());
        QCOMPARE(split->pieces, (std::vector<std::uint32_t>{3, 4}));
        QCOMPARE(split->numbers, (std::vector<std::uint32_t>{0, 1, 2, 3, 5, 6, 7, 8}));
        const SolidPartition& nine = split->partition;
        QCOMPARE(nine.partOfFragment[3], 0u);
        QCOMPARE(nine.partOfFragment[4], 1u);
        QVERIFY(std::abs(nine.volumes[3] - 0.03125) < 1e-15 && std::abs(nine.volumes[4] - 0.09375) < 1e-15);
        QCOMPARE(nine.fragmentOfSeed, (std::vector<std::uint32_t>{0, 1, 2, 3, 5, 6, 7, 8}));
        // The next split goes on with the numbers.
        const Result<SolidSplit> again = splitFragment(nine, 3, axisPlane(0, 0.75));
        QVERIFY(again);
        QCOMPARE(splitFault(nine, 3, *again, cube, kEightSeeds), std::string());
        QCOMPARE(again->pieces, (std::vector<std::uint32_t>{3, 5}));
        QCOMPARE(again->partition.partOfFragment[5], 2u);
        const std::vector<SolidContact> contacts = contactsOf(again->partition);
        const auto between =
            std::ranges::find_if(contacts, [](const auto& c) { return c.first == 3 && c.second == 5; });
        QVERIFY(between != contacts.end() && std::abs(between->area - 0.0625) < 1e-15);
    }
    void whatOnlyTouchesIsNotSplit() {
        const TriangleMesh cube = cubes({{0, 0, 0}});
        const SolidPartition eight = cellsOf(cube, kEightSeeds);
        const std::vector<SectionPlane> planes = {axisPlane(0, 0.0),
                                                  axisPlane(1, 0.5),
                                                  axisPlane(2, 0.75),
                                                  planeThrough(Vec3(0.5), Vec3(1.0)),
                                                  planeThrough(Vec3(0.0), Vec3(1.0, -1.0, 0.0) + Vec3(0, 2.0, 0)),
                                                  axisPlane(0, 0.5 + 1e-13),
                                                  axisPlane(2, -1e-13)};
        for (const SectionPlane& plane : planes) {
            const Result<SolidSplit> split = splitFragment(eight, 0, plane);
            QVERIFY(split);
            QCOMPARE(split->pieces, std::vector<std::uint32_t>{0});
            QCOMPARE(split->partition.triangles, eight.triangles);
            QCOMPARE(split->partition.partOfFragment, eight.partOfFragment);
            QCOMPARE(split->numbers.size(), 8u);
        }
    }
    void planesThroughCornersAndEdgesSplit() {
        const TriangleMesh cube = cubes({{0, 0, 0}});
        const SolidPartition eight = cellsOf(cube, kEightSeeds);
        for (const Vec3 normal : {Vec3(1, 1, -1), Vec3(1, -1, 0), Vec3(0, 1, -1), Vec3(2, -1, -1), Vec3(1, 1, -2)}) {
            const SectionPlane plane = planeThrough(Vec3(0.0), normal);
            for (const bool isTurned : {false, true}) {
                const SectionPlane used = isTurned ? SectionPlane{plane.origin, plane.y, plane.x} : plane;
                const Result<SolidSplit> split = splitFragment(eight, 0, used);
                QVERIFY(split);
                QCOMPARE(splitFault(eight, 0, *split, cube, kEightSeeds), std::string());
                QCOMPARE(split->pieces.size(), 2u);
                QVERIFY(areOnOneSide(*split, plane, 1e-12));
            }
        }
    }
    void aUFallsIntoThreeParts() {
        const TriangleMesh u = cubes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}});
        const std::vector<Vec3> seeds = {{1.5, 0.4, 0.5}};
        const SolidPartition whole = cellsOf(u, seeds);
        const Result<SolidSplit> split = splitFragment(whole, 0, axisPlane(1, 1.5));
        QVERIFY(split);
        QCOMPARE(splitFault(whole, 0, *split, u, seeds), std::string());
        QCOMPARE(split->partition.volumes.size(), 3u);
        QVERIFY(std::abs(split->partition.volumes[0] - 4.0) < 1e-14);
        QCOMPARE(split->partition.partOfFragment, (std::vector<std::uint32_t>{0, 1, 2}));
        // In the inner face, which is at the same height as the legs' lower ends.
        const Result<SolidSplit> inFace = splitFragment(whole, 0, axisPlane(1, 1.0));
        QVERIFY(inFace);
        QCOMPARE(splitFault(whole, 0, *inFace, u, seeds), std::string());
        QCOMPARE(inFace->pieces.size(), 3u);
        QVERIFY(std::abs(inFace->partition.volumes[0] - 3.0) < 1e-14);
    }
    void cavitiesStayInTheirPart() {
        const TriangleMesh ball = bumpySphere(16);
        const TriangleMesh hollow = together(transformed(ball, Mat3(2.0)), insideOut(transformed(ball, Mat3(0.4))));
        const std::vector<Vec3> seeds = {{0, 0, 0}};
        const SolidPartition whole = cellsOf(hollow, seeds);
        for (const double height : {0.0, 0.05, 1.0, -1.5}) {
            const Result<SolidSplit> split = splitFragment(whole, 0, planeThrough({0, 0, height}, {0.1, 0.2, 1.0}));
            QVERIFY(split);
            QCOMPARE(splitFault(whole, 0, *split, hollow, seeds), std::string());
            QCOMPARE(split->pieces.size(), 2u);
        }
    }
    void everythingTiesOnASmallLattice() { QCOMPARE(latticeFault(Mat3(1.0), Vec3(0.0)), QString()); }
    /// Rounding opens the ties.
    void turnedTiesAreSplitRight() {
        const Mat3 turn(Vec3(0.76, 0.64, 0.1), Vec3(-0.64, 0.77, 0.05), Vec3(0.02, 0.03, 1));
        QCOMPARE(latticeFault(turn, Vec3(10.0, -300.0, 7.0)), QString());
    }
    void randomPlanesSplitAnyShape() {
        const std::vector<TriangleMesh> shapes = {bumpySphere(16), torus(24, 10), mengerSponge(1)};
        for (std::size_t shape = 0; shape < shapes.size(); ++shape) {
            const TriangleMesh& mesh = shapes[shape];
            const std::vector<Vec3> seeds = seedsInBox(mesh, 12, shape);
            SolidPartition partition = cellsOf(mesh, seeds);
            Random random(20 + shape);
            for (int k = 0; k < 60; ++k) {
                const std::uint32_t fragment = static_cast<std::uint32_t>(random.below(partition.fragmentCount()));
                const std::uint32_t face = partition.facesOf(fragment)[0].face;
                const Vec3 corner = partition.points[partition.trianglesOf(face)[0][0]];
                const Vec3 point = partition.origin + corner + (k % 3 == 0 ? Vec3(0.0) : 0.05 * anyDirection(random));
                const SectionPlane plane = planeThrough(point, anyDirection(random));
                Result<SolidSplit> split = splitFragment(partition, fragment, plane);
                QVERIFY(split);
                const std::string fault = splitFault(partition, fragment, *split, mesh, seeds);
                QVERIFY2(fault.empty(), qPrintable(QString("%1, split %2: ").arg(shape).arg(k) + fault.c_str()));
                QVERIFY(areOnOneSide(*split, plane, 1e-11));
                partition = std::move(split->partition);
            }
            QVERIFY(partition.fragmentCount() > 40);
        }
    }
    void mergedFragmentsSplit() {
        const TriangleMesh mesh = torus(24, 10);
        const std::vector<Vec3> seeds = seedsInBox(mesh, 30, 2);
        SolidPartition partition = withoutSmallFragments(cellsOf(mesh, seeds), 0.3);
        QVERIFY(partition.fragmentCount() > 3);
        Random random(4);
        for (int k = 0; k < 30; ++k) {
            const std::uint32_t fragment = static_cast<std::uint32_t>(random.below(partition.fragmentCount()));
            const SectionPlane plane = planeThrough(anyPoint(random, partition), anyDirection(random));
            Result<SolidSplit> split = splitFragment(partition, fragment, plane);
            QVERIFY(split);
            const std::string fault = splitFault(partition, fragment, *split, mesh, seeds);
            QVERIFY2(fault.empty() || fault.find("nearer to another seed") != std::string::npos, fault.c_str());
            partition = std::move(split->partition);
        }
    }
    void sameBitsOnAnyThreads() {
        const TriangleMesh mesh = bumpySphere(24);
        const SolidPartition partition = cellsOf(mesh, seedsInBox(mesh, 20, 5));
        const SectionPlane plane = planeThrough(Vec3(0.1), Vec3(1, 2, 3));
        for (std::uint32_t fragment = 0; fragment < partition.fragmentCount(); ++fragment) {
            const Result<SolidSplit> first = splitFragment(partition, fragment, plane);
            TaskContext task;
            task.threads = 8;
            const Result<SolidSplit> other = splitFragment(partition, fragment, plane, task);
            QVERIFY(first && other);
            const auto &a = first->partition.points, &b = other->partition.points;
            QVERIFY(a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0);
            QCOMPARE(first->partition.triangles, other->partition.triangles);
        }
    }
    void badInputIsRefused() {
        const TriangleMesh cube = cubes({{0, 0, 0}});
        const SolidPartition eight = cellsOf(cube, kEightSeeds);
        QCOMPARE(splitFragment(eight, 8, axisPlane(0, 0.1)).error().code, ErrorCode::BadInput);
        const double bad = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(splitFragment(eight, 0, axisPlane(0, bad)).error().code, ErrorCode::BadInput);
        QCOMPARE(splitFragment(eight, 0, {Vec3(0.0), Vec3(bad), Vec3(0, 1, 0)}).error().code, ErrorCode::BadInput);
        TaskContext task;
        task.cancel.cancel();
        QCOMPARE(splitFragment(eight, 0, axisPlane(0, 0.25), task).error().code, ErrorCode::Cancelled);
    }
    void oneOfAThousandIsSplitFast() {
        const TriangleMesh mesh = bumpySphere(224);  // 100,000 triangles
        SolidPartition partition = cellsOf(mesh, seedsInBox(mesh, 1000, 6));
        Stopwatch watch;
        double slowest = 0.0;
        for (std::uint32_t k = 0; k < 20; ++k) {
            const std::uint32_t fragment = k * 31;
            const Vec3 corner = partition.points[partition.trianglesOf(partition.facesOf(fragment)[0].face)[0][0]];
            const SectionPlane plane = planeThrough(partition.origin + corner, Vec3(1, 2, 3));
            watch.lap();
            Result<SolidSplit> split = splitFragment(std::move(partition), fragment, plane);
            slowest = std::max(slowest, watch.lap());
            partition = std::move(split->partition);
        }
        qInfo("slowest split: %.2f ms", slowest);
        QVERIFY(slowest < 500.0);
    }
};

RUBBLE_TEST(SolidSplitTest)
#include "SolidSplitTest.moc"
