#include "core/geometry/mesh/MeshWelding.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/BrokenMeshes.h"
#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/Solids.h"

#include <QTest>

#include <limits>

using namespace rubble;
using test::unshared;

class MeshWeldingTest : public QObject {
    Q_OBJECT
private slots:
    void equalPointsAreWelded() {
        const Result<WeldedMesh> box = welded(unshared(prismSolid(unitSquare(), 1.0)));
        QCOMPARE(box->mesh.points.size(), std::size_t{8});
        QCOMPARE(box->mesh.triangles.size(), std::size_t{12});
        QCOMPARE(box->mergedPoints, std::size_t{0});
        QCOMPARE(box->droppedTriangles, std::size_t{0});
    }
    void nearPointsAreWeldedAndCounted() {
        TriangleMesh box = unshared(prismSolid(unitSquare(), 1.0));
        box.points[35].x += 1e-6;
        const Result<WeldedMesh> result = welded(box);
        QCOMPARE(result->mesh.points.size(), std::size_t{8});
        QCOMPARE(result->mergedPoints, std::size_t{1});
        QVERIFY(std::abs(result->maxMergeDistance - 1e-6) < 1e-12);
    }
    void pointsBeyondTheToleranceAreKept() {
        TriangleMesh box = unshared(prismSolid(unitSquare(), 1.0));
        box.points[4].x += 2e-5;  // the tolerance is 1.7e-5
        QCOMPARE(welded(box)->mesh.points.size(), std::size_t{9});
    }
    void degenerateTrianglesAreDroppedAndCounted() {
        TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1e-7, 0}}, {{0, 1, 3}, {0, 1, 2}}};
        const Result<WeldedMesh> result = welded(mesh);
        QCOMPARE(result->droppedTriangles, std::size_t{1});
        QCOMPARE(result->sources, std::vector<std::uint32_t>{1});
    }
    void toleranceFarFromTheOriginIsThatOfSinglePrecision() {
        TriangleMesh box = prismSolid(unitSquare(), 1.0);
        QVERIFY(std::abs(meshTolerance(box) - 1e-5 * std::sqrt(3.0)) < 1e-12);
        for (Vec3& point : box.points) point.x += 1e6;
        QVERIFY(std::abs(meshTolerance(box) - 4.0 * 1000001.0 / 16777216.0) < 1e-6);
    }
    void faultsAreReported() {
        QCOMPARE(welded({}).error().message, "The mesh has no triangle.");
        QCOMPARE(welded({{{0, 0, 0}}, {{0, 1, 0}}}).error().message, "Triangle 0 refers to point 1 of 1.");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(welded({{{0, 0, 0}, {0, nan, 0}}, {{0, 1, 0}}}).error().message,
                 "Point 1 of the mesh is not a finite number.");
        QCOMPARE(welded({{{0, 0, 0}, {0, 3.4e38, 0}}, {{0, 1, 0}}}).error().message,
                 "Point 1 of the mesh is out of range: 1e30 m or more from the origin.");
        QCOMPARE(welded({{{1, 2, 3}}, {{0, 0, 0}}}).error().code, ErrorCode::Degenerate);
        QCOMPARE(welded({{{1, 2, 3}, {4, 5, 6}}, {{0, 1, 0}}}).error().message, "No triangle of the mesh has an area.");
    }
};

RUBBLE_TEST(MeshWeldingTest)
#include "MeshWeldingTest.moc"
