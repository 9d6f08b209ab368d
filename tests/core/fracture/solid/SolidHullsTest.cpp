// Tests core/fracture/solid/SolidHulls.cpp and core/fracture/solid/ConcaveSplits.cpp.
#include "core/fracture/solid/SolidHulls.h"

#include "core/fracture/solid/SolidCut.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/hull/SimplifiedHull.h"
#include "core/geometry/mesh/SolidMesh.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>

using namespace rubble;
using namespace rubble::test;

namespace {

double volumeOfAll(const std::vector<Polytope>& hulls) {
    double volume = 0.0;
    for (const Polytope& hull : hulls) volume += massOf(hull).volume;
    return volume;
}

}  // namespace

class SolidHullsTest : public QObject {
    Q_OBJECT
private slots:
    void convexMeshesHaveOneHull() {
        const TriangleMesh cube = cubes({{0, 0, 0}});
        const Result<std::vector<Polytope>> hulls = hullsOf(cube);
        QVERIFY(hulls);
        QCOMPARE(hulls->size(), 1u);
        QCOMPARE((*hulls)[0].vertices.size(), 8u);
    }
    void anLHasTwo() {
        const Result<std::vector<Polytope>> hulls = hullsOf(cubes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
        QVERIFY(hulls);
        QCOMPARE(hulls->size(), 2u);
        QVERIFY(std::abs(volumeOfAll(*hulls) - 3.0) < 1e-9);
    }
    void noMoreThanAllowed() {
        const TriangleMesh mesh = bumpySphere(24);
        for (const int most : {1, 2, 5}) {
            const Result<std::vector<Polytope>> hulls = hullsOf(mesh, {.splits = {.maxRatio = 1.0, .maxParts = most}});
            QVERIFY(hulls);
            QVERIFY(static_cast<int>(hulls->size()) <= most);
        }
        QCOMPARE(hullsOf(mesh, {.splits = {.maxRatio = 1.0, .maxParts = 1}})->size(), 1u);
    }
    /// What is required of cuts into 100 cells: hulls exceed the fragments by 3 % in sum, and are 1.5 of each at most.
    void hullsOfFragmentsAreFewAndFollowThem() {
        for (const TriangleMesh& mesh : {bumpySphere(72), bumpySphere(40), torus(100, 50), torus(60, 24)}) {
            for (const std::uint64_t seed : {3, 7, 11}) {
                const Result<SolidPartition> partition = cutSolid(mesh, seedsInBox(mesh, 100, seed));
                QVERIFY(partition);
                const Result<std::vector<std::vector<Polytope>>> hulls = fragmentHulls(*partition);
                QVERIFY(hulls);
                double all = 0.0, solid = 0.0;
                std::size_t count = 0;
                for (std::uint32_t k = 0; k < partition->fragmentCount(); ++k) {
                    const double volume = volumeOfAll((*hulls)[k]);
                    QVERIFY(volume < 1.25 * partition->volumes[k]);
                    all += volume, solid += partition->volumes[k];
                    count += (*hulls)[k].size();
                }
                const double mean = static_cast<double>(count) / partition->fragmentCount();
                QVERIFY2(all < 1.03 * solid, qPrintable(QString::number(all / solid)));
                QVERIFY2(mean <= 1.5, qPrintable(QString::number(mean)));
            }
        }
    }
    void hullsOfFragmentsHoldThem() {
        for (const TriangleMesh& mesh : {bumpySphere(40), torus(60, 24)}) {
            const Result<SolidPartition> partition = cutSolid(mesh, seedsInBox(mesh, 100, 3));
            QVERIFY(partition);
            const Result<std::vector<std::vector<Polytope>>> hulls = fragmentHulls(*partition);
            QVERIFY(hulls);
            for (std::uint32_t k = 0; k < partition->fragmentCount(); ++k) {
                const std::vector<Polytope>& some = (*hulls)[k];
                QVERIFY(!some.empty() && some.size() <= 8);
                for (const Polytope& hull : some) {
                    QVERIFY(!verifyPolytope(hull));
                    QVERIFY(hull.vertices.size() <= kMaxCollisionCorners);
                }
                if (std::ranges::any_of(some,
                                        [](const Polytope& h) { return h.vertices.size() == kMaxCollisionCorners; }))
                    continue;  // there, details may be larger
                for (const Vec3 point : meshOf(*partition, k).points)
                    QVERIFY(distanceOutside(some, point) <= kMaxHullError);
            }
        }
    }
    /// One solid takes all splits that it asks for; of two, the one that has more to save is split.
    void splitsAreMadeWhereTheySaveMost() {
        const TriangleMesh dented = cubes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}});
        const auto large = [&](double scale) { return transformed(dented, Mat3(scale)); };
        const double volume = 5.0, excess = 0.5;  // of the hull, which cuts the notch off
        QVERIFY(std::abs(massOf(dented.points, dented.triangles).volume - volume) < 1e-9);
        QCOMPARE(hullsOf(dented)->size(), 2u);
        const auto hulls =
            hullsOfEach(2, [&](std::uint32_t k) { return large(k == 0 ? 1.0 : 10.0); }, {.sumRatio = 1.01}, {});
        QCOMPARE(hulls[0]->size(), 1u);
        QCOMPARE(hulls[1]->size(), 2u);
        QVERIFY(std::abs(volumeOfAll(*hulls[0]) - volume - excess) < 1e-9);
        const auto bounded = hullsOfEach(2, [&](std::uint32_t k) { return large(k == 0 ? 1.0 : 10.0); },
                                         {.sumRatio = 2.0, .worstRatio = 1.05}, {});
        QCOMPARE(bounded[0]->size(), 2u);
        QCOMPARE(bounded[1]->size(), 2u);
    }
    /// Hulls lie in the cells, which are convex, so a point in a hull has the seed of its fragment as its nearest.
    void hullsStayInTheirCells() {
        const TriangleMesh mesh = bumpySphere(30);
        const std::vector<Vec3> seeds = seedsInBox(mesh, 60, 4);
        const Result<SolidPartition> partition = cutSolid(mesh, seeds);
        QVERIFY(partition);
        const Result<std::vector<std::vector<Polytope>>> hulls = fragmentHulls(*partition);
        QVERIFY(hulls);
        for (std::uint32_t k = 0; k < partition->fragmentCount(); ++k) {
            const Vec3 own = seeds[partition->seedOfFragment[k]];
            for (const Polytope& hull : (*hulls)[k]) {
                for (const Vec3 vertex : hull.vertices) {
                    const Vec3 point = vertex + partition->origin;
                    for (const Vec3 seed : seeds) QVERIFY(glm::length(point - own) < glm::length(point - seed) + 1e-9);
                }
            }
        }
    }
    void coarseHullsFollowTheWhole() {
        for (const TriangleMesh& mesh : {bumpySphere(30), torus(40, 16)}) {
            const Result<std::vector<Polytope>> hulls = coarseHulls(mesh, 32);
            QVERIFY(hulls);
            const double ratio = volumeOfAll(*hulls) / signedVolume(mesh);
            QVERIFY2(ratio > 1.0 && ratio < 1.05, qPrintable(QString::number(ratio)));
            for (const Vec3 point : mesh.points) QVERIFY(distanceOutside(*hulls, point) <= kMaxHullError);
        }
    }
    void sameHullsOnAnyThreads() {
        const TriangleMesh mesh = torus(40, 16);
        const Result<SolidPartition> partition = cutSolid(mesh, seedsInBox(mesh, 50, 5));
        TaskContext task;
        task.threads = 4;
        QVERIFY(*fragmentHulls(*partition) == *fragmentHulls(*partition, {}, task));
        task.cancel.cancel();
        QVERIFY(!fragmentHulls(*partition, {}, task));
    }
    void massesOfMeshesAreThoseOfPolytopes() {
        const TriangleMesh mesh = transformed(cubes({{0, 0, 0}}), Mat3(2.0), {10.0, -3.0, 5.0});
        const MassProperties mass = massOf(mesh.points, mesh.triangles), expected = massOf((*hullsOf(mesh))[0]);
        QVERIFY(std::abs(mass.volume - 8.0) < 1e-12);
        QVERIFY(glm::length(mass.centre - expected.centre) < 1e-12);
        for (int c = 0; c < 3; ++c) QVERIFY(glm::length(mass.inertia[c] - expected.inertia[c]) < 1e-12);
    }
};

RUBBLE_TEST(SolidHullsTest)
#include "SolidHullsTest.moc"
