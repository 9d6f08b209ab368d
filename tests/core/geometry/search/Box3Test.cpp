// Tests core/geometry/search/Box3.cpp and core/geometry/mesh/TriangleMesh.cpp.
#include "core/geometry/mesh/TriangleMesh.h"
#include "core/geometry/search/Box3.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class Box3Test : public QObject {
    Q_OBJECT
private slots:
    void emptyBoxHasNoDiagonalAndAddsNothing() {
        Box3 box;
        QVERIFY(box.isEmpty());
        QCOMPARE(box.diagonal(), 0.0);
        box.include(Vec3(1.0, 2.0, 3.0));
        const Box3 before = box;
        box.include(Box3{});
        QVERIFY(box == before);
    }
    void boxGrowsToItsPointsAndBoxes() {
        Box3 box;
        box.include(Vec3(1.0, 5.0, 0.0));
        box.include(Box3{{-1.0, 6.0, 0.0}, {0.0, 7.0, 3.0}});
        QVERIFY(box == (Box3{{-1.0, 5.0, 0.0}, {1.0, 7.0, 3.0}}));
        QCOMPARE(box.diagonal(), std::sqrt(17.0));  // of 2 x 2 x 3 m
        QCOMPARE(box.centre(), Vec3(0.0, 6.0, 1.5));
    }
    void bitsOfTheIndexSelectTheCorner() {
        const Box3 box{{0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}};
        QCOMPARE(box.corner(0), box.min);
        QCOMPARE(box.corner(1), Vec3(1.0, 0.0, 0.0));
        QCOMPARE(box.corner(2), Vec3(0.0, 2.0, 0.0));
        QCOMPARE(box.corner(4), Vec3(0.0, 0.0, 3.0));
        QCOMPARE(box.corner(7), box.max);
    }
    void boxesOfEdgesAreFlat() {
        const std::vector<std::array<Vec2, 2>> edges{{Vec2(3.0, 0.0), Vec2(1.0, 2.0)}};
        QVERIFY(boxesOf(edges)[0] == (Box3{{1.0, 0.0, 0.0}, {3.0, 2.0, 0.0}}));
        QVERIFY(boxOf({1.0, 2.0}, {3.0, 0.0}) == boxesOf(edges)[0]);
    }
    void triangleMeshHasABoxAndAreas() {
        const TriangleMesh mesh{{{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {0.0, 4.0, 0.0}, {0.0, 0.0, -1.0}}, {{0, 1, 2}}};
        QCOMPARE(doubleArea(mesh, 0), Vec3(0.0, 0.0, 12.0));
        QVERIFY(boundsOf(mesh) == (Box3{{0.0, 0.0, -1.0}, {3.0, 4.0, 0.0}}));  // also of unused points
    }
};

RUBBLE_TEST(Box3Test)
#include "Box3Test.moc"
