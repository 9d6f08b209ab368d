#include "core/geometry/polygon/SweepTriangulation.h"

#include "core/base/Random.h"
#include "core/geometry/polygon/HalfEdgeTriangles.h"
#include "core/geometry/polygon/TouchingCorners.h"
#include "core/geometry/predicates/Predicates.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/Polyomino.h"

#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

/// What is wrong with the triangulation of some corners that bound an area, m^2; nothing: it fills it.
const char* fillingFault(const IndexedCorners& corners, double expectedArea) {
    const std::optional<std::vector<CornerTriangle>> found = sweepTriangulation(corners);
    if (!found) return "There is no triangulation.";
    double sum = 0.0;
    for (const auto& [a, b, c] : *found) {
        if (orient2d(corners.points[a], corners.points[b], corners.points[c]) <= 0) return "A triangle is reversed.";
        sum += signedArea(Ring{corners.points[a], corners.points[b], corners.points[c]});
    }
    if (std::abs(sum - expectedArea) > 1e-12 * expectedArea) return "The area is wrong.";  // roundings of the sum
    return linkTriangles(*found, corners) ? nullptr : "The triangles do not fit together.";
}

}  // namespace

class SweepTriangulationTest : public QObject {
    Q_OBJECT
private slots:
    void squareHasTwoTriangles() {
        const auto found = sweepTriangulation(indexedCorners(unitSquare()));
        QVERIFY(found && found->size() == 2);
        QCOMPARE(fillingFault(indexedCorners(unitSquare()), 1.0), nullptr);
    }
    void holesAreLeftOpen() {
        const auto found = sweepTriangulation(indexedCorners(squareRing()));
        QVERIFY(found && found->size() == 8);  // corners + 2 holes - 2
        QCOMPARE(fillingFault(indexedCorners(squareRing()), 12.0), nullptr);
    }
    void reversedRingIsRejected() { QVERIFY(!sweepTriangulation(indexedCorners({reversed(unitSquare().outer), {}}))); }
    void starsWithHolesAreFilled() {
        for (std::uint64_t number = 1; number <= 300; ++number) {
            Random random(number);
            const auto points = 3 + static_cast<std::uint32_t>(random.below(20));
            const Vec2 centre(random.between(-9.0, 9.0), random.between(-9.0, 9.0));
            Polygon polygon{star(2 * points, random.between(0.5, 0.9), 1.0, centre), {}};
            if (number % 2 == 0) polygon.holes.push_back(reversed(star(6, 0.1, 0.2, centre)));
            const auto found = sweepTriangulation(indexedCorners(polygon));
            const std::string name = "random seed " + std::to_string(number);
            const std::size_t corners = cornersOf(polygon).size();
            QVERIFY2(found && found->size() == corners + 2 * polygon.holes.size() - 2, name.c_str());
            const char* fault = fillingFault(indexedCorners(polygon), area(polygon));
            QVERIFY2(!fault, (name + ": " + (fault ? fault : "")).c_str());
        }
    }
    void facesThatTouchThemselvesAreFilled() {
        for (std::uint64_t number = 1; number <= 300; ++number) {
            Random random(number);
            Polyomino cells(6, 6);
            for (int x = 0; x < 6; ++x)
                for (int y = 0; y < 6; ++y) cells.set(x, y, random.below(5) < 3);
            cells.set(3, 3, true);
            const Polygon polygon = cells.componentAt(3, 3);
            IndexedCorners corners = indexedCorners(polygon);
            QVERIFY(splitTouchingCorners(corners));
            const char* fault = fillingFault(corners, area(polygon));
            QVERIFY2(!fault, ("random seed " + std::to_string(number) + ": " + (fault ? fault : "")).c_str());
        }
    }
    void workIsCounted() {
        std::size_t steps = 0;
        QVERIFY(sweepTriangulation(indexedCorners(squareRing()), &steps));
        QVERIFY(steps > 0);
    }
};

RUBBLE_TEST(SweepTriangulationTest)
#include "SweepTriangulationTest.moc"
