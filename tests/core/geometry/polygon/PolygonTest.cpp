// Tests core/geometry/polygon/Polygon.cpp and core/geometry/polygon/RayCrossings.cpp.
#include "core/geometry/polygon/Polygon.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

class PolygonTest : public QObject {
    Q_OBJECT
private slots:
    void areaIsSignedByWinding() {
        QCOMPARE(signedArea(lShape().outer), 3.0);
        QCOMPARE(signedArea(reversed(lShape().outer)), -3.0);
        QCOMPARE(signedArea(Ring{{0.0, 0.0}, {1.0, 1.0}}), 0.0);
        QCOMPARE(signedArea(Ring{}), 0.0);
    }
    void areaIsAccurateFarFromTheOrigin() {
        const double side = 0x1p-20;
        QCOMPARE(signedArea(rectangle({1e6, 1e6}, {1e6 + side, 1e6 + side})), side * side);
    }
    void areaSubtractsHolesOfAnyWinding() {
        Polygon polygon = squareRing();
        QCOMPARE(area(polygon), 12.0);
        polygon.holes[0] = reversed(polygon.holes[0]);
        QCOMPARE(area(polygon), 12.0);
        polygon.outer = reversed(polygon.outer);
        QCOMPARE(area(polygon), 12.0);
    }
    void centroidIsWeightedByArea() {
        // Two squares and one: (2 * (1, .5) + 1 * (.5, 1.5)) / 3.
        const Vec2 centre = centroid(lShape());
        QVERIFY(glm::distance(centre, Vec2(2.5 / 3.0, 2.5 / 3.0)) < 1e-15);
        // A hole of a quarter of the area on one side: (16 * 2 - 4 * 1) / 12 = 7 / 3.
        const Polygon offCentre{rectangle({0.0, 0.0}, {4.0, 4.0}), {rectangle({0.0, 1.0}, {2.0, 3.0})}};
        QVERIFY(glm::distance(centroid(offCentre), Vec2(7.0 / 3.0, 2.0)) < 1e-15);
    }
    void centroidOfZeroAreaIsTheMeanOfTheCorners() {
        QCOMPARE(centroid({{{0.0, 0.0}, {1.0, 0.0}, {5.0, 0.0}}, {}}), Vec2(2.0, 0.0));
        QCOMPARE(centroid({}), Vec2(0.0, 0.0));
    }
    void perimeterAndBounds() {
        QCOMPARE(perimeter(lShape().outer), 8.0);
        const Box2 box = boundsOf(lShape().outer);
        QCOMPARE(box.min, Vec2(0.0, 0.0));
        QCOMPARE(box.max, Vec2(2.0, 2.0));
        QCOMPARE(boundsOf(rectangle({0.0, 0.0}, {3.0, 4.0})).diagonal(), 5.0);
        QCOMPARE(Box2{}.diagonal(), 0.0);
    }
    void canonicalWindingKeepsFirstCorners() {
        Polygon polygon = squareRing();
        const Polygon canonical = polygon;
        std::reverse(polygon.outer.begin() + 1, polygon.outer.end());
        std::reverse(polygon.holes[0].begin() + 1, polygon.holes[0].end());
        QVERIFY(polygon != canonical);
        QVERIFY(withCanonicalWinding(polygon) == canonical);
        QVERIFY(withCanonicalWinding(canonical) == canonical);
        QVERIFY(withCanonicalWinding({}) == Polygon{});
    }
    void canonicalWindingIsExactForSlivers() {
        // The third corner lies one ulp above the line through the others.
        const Ring sliver{{0.0, 0.0}, {3.0, 3.0}, {1.0, std::nextafter(1.0, 2.0)}};
        const Ring clockwise{sliver[0], sliver[2], sliver[1]};
        QVERIFY(withCanonicalWinding({sliver, {}}).outer == sliver);
        QVERIFY(withCanonicalWinding({clockwise, {}}).outer == sliver);
    }
    void containmentDistinguishesInsideBoundaryAndHole() {
        const Polygon polygon = squareRing();
        QCOMPARE(containment(polygon, {0.5, 2.0}), Containment::Inside);
        QCOMPARE(containment(polygon, {2.0, 2.0}), Containment::Outside);
        QCOMPARE(containment(polygon, {1.0, 2.0}), Containment::OnBoundary);
        QCOMPARE(containment(polygon, {4.0, 4.0}), Containment::OnBoundary);
        QCOMPARE(containment(polygon, {2.0, 0.0}), Containment::OnBoundary);
        QCOMPARE(containment(polygon, {5.0, 0.0}), Containment::Outside);
        QCOMPARE(containment(polygon, {-1.0, 1.0}), Containment::Outside);
        QCOMPARE(containment({}, {0.0, 0.0}), Containment::Outside);
    }
    void containmentIsExactOneUlpFromAnEdge() {
        const Polygon triangle{{{0.0, 0.0}, {3.0, 3.0}, {0.0, 3.0}}, {}};
        QCOMPARE(containment(triangle, {0.3, 0.3}), Containment::OnBoundary);
        QCOMPARE(containment(triangle, {0.3, std::nextafter(0.3, 1.0)}), Containment::Inside);
        QCOMPARE(containment(triangle, {0.3, std::nextafter(0.3, 0.0)}), Containment::Outside);
    }
    void rayThroughACornerIsCountedOnce() {
        const Polygon rhomb{{{0.0, -1.0}, {1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}}, {}};
        QCOMPARE(containment(rhomb, {0.0, 0.0}), Containment::Inside);
        QCOMPARE(containment(rhomb, {-2.0, 0.0}), Containment::Outside);
        QCOMPARE(containment(rhomb, {-2.0, 1.0}), Containment::Outside);
    }
    void convexRingsHaveNoReflexCorner() {
        QVERIFY(isConvex(unitSquare().outer));
        QVERIFY(!isConvex(lShape().outer));
        QVERIFY(!isConvex(reversed(unitSquare().outer)));
        QVERIFY(isConvex(Ring{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}}));  // a collinear corner is not reflex
    }
};

RUBBLE_TEST(PolygonTest)
#include "PolygonTest.moc"
