// Tests core/fracture/solid/SampledHulls.cpp.
#include "core/fracture/solid/SampledHulls.h"

#include "core/fracture/solid/SolidHulls.h"
#include "core/geometry/hull/MassProperties.h"
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

constexpr int kCells = 32;

double ratioOf(const std::vector<Polytope>& hulls, const TriangleMesh& mesh) {
    double volume = 0.0;
    for (const Polytope& hull : hulls) volume += massOf(hull).volume;
    return volume / signedVolume(mesh);
}

}  // namespace

class SampledHullsTest : public QObject {
    Q_OBJECT
private slots:
    void hullsFollowTheMesh() {
        for (const TriangleMesh& mesh : {bumpySphere(72), torus(100, 50)}) {
            const Result<std::vector<Polytope>> hulls = sampledHulls(mesh, kCells);
            QVERIFY(hulls);
            const double ratio = ratioOf(*hulls, mesh);
            QVERIFY2(ratio > 0.98 && ratio < 1.06, qPrintable(QString::number(ratio)));
            const double size = boundsOf(mesh).diagonal();
            for (const Vec3 point : mesh.points) QVERIFY(distanceOutside(*hulls, point) < 0.01 * size);
            for (const Polytope& hull : *hulls) {
                QVERIFY(!verifyPolytope(hull));
                QVERIFY(hull.vertices.size() <= 128);
            }
        }
    }
    /// A plate with a rib: too thin for points inside it, with large triangles.
    void thinAndCoarseMeshesHaveHulls() {
        const TriangleMesh l = cubes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        const TriangleMesh mesh = transformed(l, Mat3(Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1e-4)));
        const Result<std::vector<Polytope>> hulls = sampledHulls(mesh, kCells);
        QVERIFY(hulls);
        QVERIFY(std::abs(ratioOf(*hulls, mesh) - 1.0) < 0.06);
    }
    /// Parts that are concave get more seeds; a convex mesh keeps those it began with.
    void concavePartsGetMoreSeeds() {
        QCOMPARE(sampledSeeds(cubes({{0, 0, 0}}), kCells).size(), std::size_t{kCells});
        const std::size_t more = sampledSeeds(mengerSponge(2), kCells).size();
        QVERIFY(more > kCells && more <= 4 * kCells);
    }
    void manyTrianglesAreCutOnce() {
        const TriangleMesh mesh = bumpySphere(130);
        QVERIFY(mesh.triangles.size() > 30'000);
        QVERIFY(*coarseHulls(mesh, kCells) == *sampledHulls(mesh, kCells));
    }
    void sameHullsOnAnyThreads() {
        const TriangleMesh mesh = bumpySphere(40);
        TaskContext task;
        task.threads = 4;
        QVERIFY(*sampledHulls(mesh, kCells) == *sampledHulls(mesh, kCells, task));
    }
    void cancellationEndsIt() {
        TaskContext task;
        task.cancel.cancel();
        const Result<std::vector<Polytope>> hulls = sampledHulls(bumpySphere(40), kCells, task);
        QVERIFY(!hulls);
        QCOMPARE(hulls.error().code, ErrorCode::Cancelled);
    }
    /// Nothing more is reported then.
    void cancelsInEachStage() {
        const TriangleMesh mesh = bumpySphere(40);
        std::vector<double> reports;
        TaskContext task;
        task.progress = [&](double fraction) { reports.push_back(fraction); };
        QVERIFY(sampledHulls(mesh, kCells, task));
        QVERIFY(reports.size() >= 8 && std::ranges::is_sorted(reports));
        for (const double at : reports) {
            TaskContext cancelled;
            double last = 0.0;
            cancelled.progress = [&](double fraction) {
                last = fraction;
                if (fraction >= at) cancelled.cancel.cancel();
            };
            const Result<std::vector<Polytope>> hulls = sampledHulls(mesh, kCells, cancelled);
            QVERIFY(!hulls && hulls.error().code == ErrorCode::Cancelled);
            QCOMPARE(last, at);
        }
    }
    void meshesWithoutAreaHaveNone() {
        const TriangleMesh line{{Vec3(0.0), Vec3(1.0), Vec3(2.0)}, {{0, 1, 2}}};
        QVERIFY(sampledSeeds(line, kCells).empty());
        QVERIFY(!sampledHulls(line, kCells));
    }
};

RUBBLE_TEST(SampledHullsTest)
#include "SampledHullsTest.moc"
