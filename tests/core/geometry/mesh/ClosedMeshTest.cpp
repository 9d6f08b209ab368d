#include "core/geometry/mesh/ClosedMesh.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

class ClosedMeshTest : public QObject {
    Q_OBJECT
private slots:
    void hasBoundsMassAndHash() {
        const auto cube = closedMesh(cubes({{0, 0, 0}, {1, 0, 0}}));
        QVERIFY(cube);
        QCOMPARE((*cube)->bounds.max, Vec3(2.0, 1.0, 1.0));
        QVERIFY(std::abs((*cube)->mass.volume - 2.0) < 1e-12);
        QVERIFY(glm::distance((*cube)->mass.centre, Vec3(1.0, 0.5, 0.5)) < 1e-12);
        QCOMPARE((*cube)->hash, (*closedMesh(cubes({{0, 0, 0}, {1, 0, 0}})))->hash);
        QVERIFY((*cube)->hash != (*closedMesh(cubes({{0, 0, 0}})))->hash);
    }
    void meshesThatCannotBeCutAreRefused() {
        TriangleMesh open = cubes({{0, 0, 0}});
        open.triangles.pop_back();
        const auto refused = closedMesh(open);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::Degenerate);
        QVERIFY2(refused.error().message.find("one face only") != std::string::npos, refused.error().message.c_str());
    }
    /// A file holds what was judged, so a mesh that something would have to be done to is not that.
    void meshesThatWouldBeChangedAreRefused() {
        const auto refused = closedMesh(insideOut(cubes({{0, 0, 0}})));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::Degenerate);
        const Result<MeshVerdict> verdict = judgeMesh(insideOut(cubes({{0, 0, 0}})));
        QVERIFY(closedMesh(*verdict)->mass.volume > 0.0);
    }
    void scalingKeepsTheCentre() {
        const auto sphere = *closedMesh(bumpySphere(12));
        const auto larger = scaled(*sphere, {2.0, 1.0, 3.0});
        QVERIFY(glm::distance(larger->bounds.centre(), sphere->bounds.centre()) < 1e-12);
        QVERIFY(std::abs(larger->mass.volume - 6.0 * sphere->mass.volume) < 1e-9);
    }
};

RUBBLE_TEST(ClosedMeshTest)
#include "ClosedMeshTest.moc"
