// Tests core/fracture/solid/SolidCut.cpp, core/fracture/solid/SurfaceWalk.cpp, core/fracture/solid/InnerFaces.cpp,
// core/fracture/solid/SolidPoints.cpp, core/fracture/solid/SolidPlacement.cpp, core/fracture/solid/FaceLoops.cpp,
// core/fracture/solid/SolidFaces.cpp, core/fracture/solid/LoopNesting.cpp, core/fracture/solid/SolidShells.cpp and
// core/fracture/verify/VerifySolidPartition.cpp.
#include "core/fracture/solid/SolidCut.h"

#include "core/base/math/Trigonometry.h"
#include "core/fracture/verify/VerifySolidPartition.h"
#include "core/geometry/mesh/SolidMesh.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/CutFault.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstring>
#include <limits>

using namespace rubble;
using namespace rubble::test;

namespace {

/// Seeds in the middles of the cells of a grid over a mesh's box.
std::vector<Vec3> gridSeeds(const TriangleMesh& mesh, int count) {
    const Box3 box = boundsOf(mesh);
    std::vector<Vec3> seeds;
    for (int k = 0; k < count * count * count; ++k) {
        const Vec3 cell(k % count, k / count % count, k / count / count);
        seeds.push_back(box.min + (box.max - box.min) * (cell + 0.5) / double(count));
    }
    return seeds;
}

TriangleMesh block(int x, int y, int z) {
    std::set<std::array<int, 3>> filled;
    for (int k = 0; k < x * y * z; ++k) filled.insert({k % x, k / x % y, k / x / y});
    return cubes(filled);
}

/// A U of three blocks whose legs, turned inward, touch in a face, with points of their own there.
TriangleMesh touchingU() {
    const TriangleMesh left = cubes({{0, 0, 0}, {0, 0, 1}}), right = cubes({{1, 0, 0}, {1, 0, 1}});
    return together(left, right);
}

TriangleMesh shapeL() { return cubes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 2, 0}}); }

Mat3 turned() {
    const double c = cosine(0.7), s = sine(0.7);
    return Mat3(Vec3(c, s, 0), Vec3(-s, c, 0), Vec3(0, 0, 1)) * Mat3(Vec3(1, 0, 0), Vec3(0, c, s), Vec3(0, -s, c));
}

/// A mesh and seeds on a lattice of few points, where everything ties; the mesh may be empty.
std::pair<TriangleMesh, std::vector<Vec3>> latticeCase(std::uint64_t number) {
    Random random(number);
    TriangleMesh mesh = randomLatticeMesh(random, number % 2 == 1);
    if (mesh.triangles.empty()) return {};
    std::vector<Vec3> seeds(1 + random.below(random.below(3) == 0 ? 40 : 8));
    const double scale = random.below(2) == 0 ? 1.0 : 0.5, offset = random.below(3) == 0 ? -1.0 : 0.0;
    for (Vec3& point : seeds) {
        const double x = static_cast<double>(random.below(5)), y = static_cast<double>(random.below(5));
        point = scale * Vec3(x, y, static_cast<double>(random.below(5))) + offset;
    }
    return {std::move(mesh), std::move(seeds)};
}

bool areSameBits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

}  // namespace

class SolidCutTest : public QObject {
    Q_OBJECT
private slots:
    void aCubeIsHalved() {
        const TriangleMesh cube = block(1, 1, 1);
        const std::vector<Vec3> seeds = {{0.25, 0.5, 0.5}, {0.75, 0.5, 0.5}};
        const Result<SolidPartition> halves = cutSolid(cube, seeds);
        QVERIFY(halves);
        QCOMPARE(halves->fragmentCount(), 2u);
        for (const double volume : halves->volumes) QVERIFY(std::abs(volume - 0.5) < 1e-15);
        QCOMPARE(std::ranges::count_if(halves->faces, [](const auto& face) { return face.behind != kNone; }), 1);
        QCOMPARE(verifySolidPartition(*halves, cube, seeds).value_or(""), std::string());
    }
    void oneSeedLeavesTheMesh() {
        const TriangleMesh mesh = bumpySphere(20);
        const Result<SolidPartition> whole = cutSolid(mesh, std::vector{Vec3(0.1, 0.2, 0.3)});
        QVERIFY(whole);
        QCOMPARE(whole->fragmentCount(), 1u);
        QCOMPARE(whole->triangles, mesh.triangles);
    }
    void randomSeedsCutAnyShape() {
        const std::vector<TriangleMesh> shapes = {bumpySphere(24), torus(40, 16), mengerSponge(1), shapeL(),
                                                  transformed(mengerSponge(1), turned(), {100.0, -3.0, 7.0})};
        for (std::size_t shape = 0; shape < shapes.size(); ++shape) {
            for (const int count : {2, 5, 30, 200}) {
                const std::string fault = cutFault(shapes[shape], seedsInBox(shapes[shape], count, shape));
                QVERIFY2(fault.empty(), qPrintable(QString("%1, %2 seeds: ").arg(shape).arg(count) + fault.c_str()));
            }
        }
    }
    void gridsOfSeedsTieEverywhere() {
        for (const TriangleMesh& mesh : {block(1, 1, 1), block(5, 5, 5), block(3, 2, 4), mengerSponge(1), shapeL()}) {
            for (int count = 1; count <= 6; ++count) {
                const std::string fault = cutFault(mesh, gridSeeds(mesh, count));
                QVERIFY2(fault.empty(), fault.c_str());
            }
        }
        const Result<SolidPartition> cubelets = cutSolid(block(10, 10, 10), gridSeeds(block(10, 10, 10), 5));
        QVERIFY(cubelets);
        QCOMPARE(cubelets->fragmentCount(), 125u);
        for (const double volume : cubelets->volumes) QVERIFY(std::abs(volume - 8.0) < 1e-11);
    }
    /// Where rounding to the lattice opens every tie: cubes, with the faces of cubes only.
    void turnedGridsOfSeedsTie() {
        for (const int cells : {2, 3, 5}) {
            for (const int count : {2, 3, 5, 10}) {
                const TriangleMesh straight = block(cells, cells, cells);
                const TriangleMesh mesh = transformed(straight, turned(), {3.0, 1.0, 2.0});
                std::vector<Vec3> seeds = gridSeeds(straight, count);
                for (Vec3& seed : seeds) seed = turned() * seed + Vec3(3.0, 1.0, 2.0);
                const Result<SolidPartition> partition = cutSolid(mesh, seeds);
                QVERIFY(partition);
                QCOMPARE(verifySolidPartition(*partition, mesh, seeds).value_or(""), std::string());
                QCOMPARE(std::ranges::count_if(partition->faces, [](const auto& face) { return face.behind != kNone; }),
                         3 * count * count * (count - 1));
            }
        }
    }
    /// Seeds mirrored on faces, so that bisectors lie in them: the cells outside get nothing.
    void mirroredSeedsLeaveNoThinFragments() {
        const TriangleMesh mesh = shapeL();
        std::vector<Vec3> seeds;
        for (const Vec3 inside : {Vec3(0.5, 0.5, 0.5), Vec3(1.5, 0.25, 0.5), Vec3(0.25, 1.75, 0.75)}) {
            seeds.push_back(inside);
            for (int axis = 0; axis < 3; ++axis) {
                for (const double plane : {0.0, 1.0}) {
                    Vec3 mirrored = inside;
                    mirrored[axis] = 2.0 * plane - inside[axis];
                    seeds.push_back(mirrored);
                }
            }
        }
        const std::string fault = cutFault(mesh, seeds);
        QVERIFY2(fault.empty(), fault.c_str());
        const Result<SolidPartition> partition = cutSolid(mesh, seeds);
        for (const double volume : partition->volumes) QVERIFY(volume > 1e-3);
        std::ranges::reverse(seeds);  // the ranks of ties the other way round
        QCOMPARE(cutFault(mesh, seeds), std::string());
    }
    void nestedShellsAreCavities() {
        const TriangleMesh outer = bumpySphere(24), ball = transformed(bumpySphere(16), Mat3(0.4));
        const TriangleMesh hollow = together(outer, insideOut(ball)),
                           filled = together(hollow, transformed(ball, Mat3(0.5)));
        for (const TriangleMesh& mesh : {hollow, filled}) {
            for (const int count : {1, 2, 20, 100}) {
                const std::string fault = cutFault(mesh, seedsInBox(mesh, count, 9));
                QVERIFY2(fault.empty(), fault.c_str());
            }
        }
        const Result<SolidPartition> one = cutSolid(filled, std::vector{Vec3(0.0)});
        QVERIFY(one);
        QCOMPARE(one->fragmentCount(), 2u);  // the hollow ball, and the one in it
        QVERIFY(std::abs(one->volumes[0] + one->volumes[1] - signedVolume(filled)) < 1e-12);
    }
    void thinPlatesAreCut() {
        const TriangleMesh plate = transformed(block(10, 10, 1), Mat3(Vec3(100, 0, 0), Vec3(0, 100, 0), Vec3(0, 0, 1)));
        for (const TriangleMesh& mesh : {plate, transformed(plate, turned())}) {
            const std::string fault = cutFault(mesh, seedsInBox(mesh, 100, 11));
            QVERIFY2(fault.empty(), fault.c_str());
        }
    }
    void touchingFacesJoinNothing() {
        const TriangleMesh mesh = touchingU();
        const Result<SolidPartition> one = cutSolid(mesh, std::vector{Vec3(1.0, 0.5, 1.0)});
        QVERIFY(one);
        QCOMPARE(one->fragmentCount(), 2u);
        for (const int count : {2, 5, 20}) {
            const std::string fault = cutFault(mesh, seedsInBox(mesh, count, 12));
            QVERIFY2(fault.empty(), fault.c_str());
        }
        QCOMPARE(cutFault(mesh, {{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}, {0.5, 0.5, 1.5}, {1.5, 0.5, 1.5}}), std::string());
    }
    /// RUBBLE_LONG: 100,000 cases, else 5,000.
    void everythingTiesOnASmallLattice() {
        const int wanted = qEnvironmentVariableIsSet("RUBBLE_LONG") ? 100'000 : 5'000;
        int cut = 0;
        for (std::uint64_t seed = 0; cut < wanted; ++seed) {
            const auto [mesh, seeds] = latticeCase(seed);
            if (mesh.triangles.empty()) continue;
            const std::string fault = cutFault(mesh, seeds);
            QVERIFY2(fault.empty(), qPrintable(QString("seed %1: ").arg(seed) + fault.c_str()));
            ++cut;
        }
    }
    /// Rounding to the lattice opens the ties of turned meshes, and may let their parts cross by hardly anything.
    void turnedTiesAreCutRight() {
        int cut = 0;
        for (std::uint64_t seed = 200; cut < 1500; ++seed) {
            auto [mesh, seeds] = latticeCase(seed);
            if (mesh.triangles.empty()) continue;
            const Mat3 matrix(Vec3(0.76, 0.64, 0.1), Vec3(-0.64, 0.77, 0.05), Vec3(0.02, 0.03, 1));
            mesh = transformed(mesh, matrix);
            for (Vec3& point : seeds) point = matrix * point;
            ++cut;
            const std::string fault = cutFault(mesh, seeds);
            QVERIFY2(fault.empty(), qPrintable(QString("seed %1: ").arg(seed) + fault.c_str()));
        }
    }
    /// The lattice decides, but does not show: nearly all points have the digits of the seeds as given.
    void pointsAreBetweenTheSeedsAsGiven() {
        const TriangleMesh mesh = torus(60, 24);
        const std::vector<Vec3> seeds = seedsInBox(mesh, 100, 17);
        const Result<SolidPartition> partition = cutSolid(mesh, seeds);
        QVERIFY(partition);
        int exact = 0, all = 0;
        for (std::uint32_t f = 0; f < partition->faces.size(); ++f) {
            const SolidPartition::Face& face = partition->faces[f];
            if (face.behind == kNone) continue;
            const Vec3 a = seeds[partition->seedOfFragment[face.fragment]];
            const Vec3 b = seeds[partition->seedOfFragment[face.behind]];
            for (const std::array<std::uint32_t, 3>& triangle : partition->trianglesOf(f)) {
                for (const std::uint32_t point : triangle) {
                    const Vec3 offset = partition->origin + partition->points[point] - (a + b) / 2.0;
                    const double distance = std::abs(glm::dot(offset, glm::normalize(b - a)));
                    QVERIFY(distance < 1e-10);
                    ++all;
                    exact += distance < 2e-15;
                }
            }
        }
        QVERIFY2(exact > 0.97 * all, qPrintable(QString("%1 of %2").arg(exact).arg(all)));
    }
    void sameBitsOnAnyThreads() {
        const TriangleMesh mesh = bumpySphere(60);
        const std::vector<Vec3> seeds = seedsInBox(mesh, 200, 13);
        const Result<SolidPartition> first = cutSolid(mesh, seeds);
        QVERIFY(first);
        for (const int threads : {2, 3, 8}) {
            TaskContext task;
            task.threads = threads;
            const Result<SolidPartition> other = cutSolid(mesh, seeds, task);
            QVERIFY(other);
            QVERIFY(areSameBits(first->points, other->points));
            QCOMPARE(other->triangles, first->triangles);
            QCOMPARE(other->seedOfFragment, first->seedOfFragment);
        }
    }
    /// The lattice is bound to the axes, so a mesh that is turned by a quarter gives the turned result.
    void quarterTurnsTurnTheResult() {
        const TriangleMesh mesh = bumpySphere(24);
        const std::vector<Vec3> seeds = seedsInBox(mesh, 50, 14);
        const Mat3 turn(Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 0));
        std::vector<Vec3> turnedSeeds;
        for (const Vec3 seed : seeds) turnedSeeds.push_back(turn * seed);
        const Result<SolidPartition> a = cutSolid(mesh, seeds), b = cutSolid(transformed(mesh, turn), turnedSeeds);
        QVERIFY(a && b);
        QCOMPARE(a->fragmentCount(), b->fragmentCount());
        for (std::uint32_t k = 0; k < seeds.size(); ++k) {
            const std::uint32_t in = a->fragmentOfSeed[k], out = b->fragmentOfSeed[k];
            QCOMPARE(in == kNone, out == kNone);
            if (in != kNone) QVERIFY(std::abs(a->volumes[in] - b->volumes[out]) < 1e-12);
        }
    }
    void crossingSurfacesAreRefusedOrWrongButEnd() {
        const TriangleMesh crossing = together(block(2, 2, 2), transformed(block(2, 2, 2), Mat3(1.0), Vec3(1.0)));
        const Result<SolidPartition> cut = cutSolid(crossing, seedsInBox(crossing, 50, 15));
        if (!cut) QCOMPARE(cut.error().code, ErrorCode::Degenerate);
    }
    void whatIsNoNumberIsRefused() {
        const double none = std::numeric_limits<double>::quiet_NaN(), far = 1e300;
        const TriangleMesh cube = block(1, 1, 1);
        for (const double bad : {none, far, std::numeric_limits<double>::infinity()}) {
            TriangleMesh mesh = cube;
            mesh.points[3].y = bad;
            QCOMPARE(cutSolid(mesh, std::vector{Vec3(0.5)}).error().code, ErrorCode::BadInput);
            QCOMPARE(cutSolid(cube, std::vector{Vec3(0.5), Vec3(0.1, 0.1, bad)}).error().code, ErrorCode::BadInput);
        }
        QCOMPARE(cutSolid(cube, std::vector<Vec3>()).error().code, ErrorCode::BadInput);
        QCOMPARE(cutSolid(TriangleMesh(), std::vector{Vec3(0.5)}).error().code, ErrorCode::BadInput);
    }
    void cancels() {
        TaskContext task;
        task.cancel.cancel();
        const TriangleMesh mesh = block(1, 1, 1);
        const Result<SolidPartition> cut = cutSolid(mesh, seedsInBox(mesh, 5, 1), task);
        QVERIFY(!cut && cut.error().code == ErrorCode::Cancelled);
    }
    /// Wherever it is cancelled, it ends soon, and it says so.
    void cancelsInEachStage() {
        const TriangleMesh mesh = bumpySphere(60);
        const std::vector<Vec3> seeds = seedsInBox(mesh, 1500, 17);
        std::vector<double> reports;
        TaskContext task;
        task.progress = [&](double fraction) { reports.push_back(fraction); };
        QVERIFY(cutSolid(mesh, seeds, task));
        QVERIFY(reports.size() >= 8 && std::ranges::is_sorted(reports));
        QCOMPARE(reports.back(), 1.0);
        reports.pop_back();  // then the work is done
        for (const int threads : {1, 2}) {
            for (const double at : reports) {
                TaskContext cancelled;
                cancelled.threads = threads;
                double last = 0.0;
                cancelled.progress = [&](double fraction) {
                    last = fraction;
                    if (fraction >= at) cancelled.cancel.cancel();
                };
                const Result<SolidPartition> cut = cutSolid(mesh, seeds, cancelled);
                QVERIFY(!cut && cut.error().code == ErrorCode::Cancelled);
                QCOMPARE(last, at);
            }
        }
    }
    void verificationFindsFaults() {
        const TriangleMesh mesh = bumpySphere(12);
        const std::vector<Vec3> seeds = seedsInBox(mesh, 8, 16);
        const Result<SolidPartition> good = cutSolid(mesh, seeds);
        QVERIFY(good && !verifySolidPartition(*good, mesh, seeds));
        const auto faultAfter = [&](const auto& change) {
            SolidPartition bad = *good;
            change(bad);
            return verifySolidPartition(bad, mesh, seeds).value_or("");
        };
        QVERIFY(!faultAfter([](SolidPartition& p) { p.triangles.back()[0] = 0; }).empty());
        QVERIFY(!faultAfter([](SolidPartition& p) { p.triangles[0][1] = p.triangles[0][0]; }).empty());
        QVERIFY(!faultAfter([](SolidPartition& p) { p.triangles[5][2] = 1u << 30; }).empty());
        QVERIFY(!faultAfter([](SolidPartition& p) { p.points[3] += Vec3(0.0, 0.0, 1e-6); }).empty());
        QVERIFY(!faultAfter([](SolidPartition& p) { p.volumes[0] *= 1.0001; }).empty());
        QVERIFY(!faultAfter([](SolidPartition& p) { p.volumes[0] = -p.volumes[0]; }).empty());
        QVERIFY(!faultAfter([](SolidPartition& p) { std::swap(p.seedOfFragment[0], p.seedOfFragment[1]); }).empty());
        QVERIFY(!faultAfter([](SolidPartition& p) { p.faces[0].source = kNone; }).empty());
        QVERIFY(!faultAfter([](SolidPartition& p) { p.faces.back().behind = 1000; }).empty());
        QVERIFY(!faultAfter([](SolidPartition& p) { p.firstTriangle.pop_back(); }).empty());
        std::vector<Vec3> others = seeds;
        std::swap(others[0], others[1]);
        QVERIFY(verifySolidPartition(*good, mesh, others));
    }
};

RUBBLE_TEST(SolidCutTest)
#include "SolidCutTest.moc"
