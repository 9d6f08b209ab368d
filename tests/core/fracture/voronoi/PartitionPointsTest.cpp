#include "core/fracture/voronoi/PartitionPoints.h"

#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/TracedCells.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>

using namespace rubble;
using test::TracedCells;

class PartitionPointsTest : public QObject {
    Q_OBJECT
private slots:
    void pointsAreCornersThenVerticesThenCrossings() {
        const TracedCells cells(unitSquare(), {{0.25, 0.5}, {0.75, 0.5}});
        QCOMPARE(cells.numbers.vertices, 2u);  // after both ghost triangles
        QCOMPARE(cells.numbers.crossings, 6u);
        QCOMPARE(cells.numbers.count, 8u);
        QVERIFY(std::isinf(cells.points[0].x));
        QCOMPARE(cells.points[3], Vec2(1.0, 0.0));
        QCOMPARE(cells.points[6], Vec2(0.5, 0.0));
        QCOMPARE(cells.points[7], Vec2(0.5, 1.0));
    }
    void pointsAreRelativeToTheFrame() {
        Polygon far = unitSquare();
        for (Vec2& corner : far.outer) corner += Vec2(1024.0, 2048.0);
        const TracedCells cells(far, {{1024.25, 2048.5}, {1024.75, 2048.5}});
        QCOMPARE(cells.frame.origin, Vec2(1024.0, 2048.0));
        QCOMPARE(cells.points[3], Vec2(1.0, 0.0));
        QCOMPARE(cells.points[6], Vec2(0.5, 0.0));
    }
    void pointsAreAsFarFromAllTheirSites() {
        for (std::uint64_t number = 1; number <= 200; ++number) {
            Random random(number);
            const TracedCells cells(combWithHole(), test::randomSeeds(random, 30, number % 2 == 0));
            const Delaunay& delaunay = cells.delaunay;
            const auto isAsFar = [&](std::uint32_t point, std::uint32_t a, std::uint32_t b) {
                const Vec2 position = cells.points[point] + cells.frame.origin;
                const double one = glm::distance(position, delaunay.sites[a]);
                // The error of a point far away is relative to its distance.
                return std::abs(one - glm::distance(position, delaunay.sites[b])) <=
                       4.0 * kConstructionError * (8.0 + one);
            };
            for (std::uint32_t k = 0; k < delaunay.triangles.size(); ++k) {
                if (delaunay.triangles[k].isGhost()) continue;
                const auto& corner = delaunay.triangles[k].corner;
                if (glm::length(cells.points[k]) > 20.0) continue;  // not a corner of a piece: less accurate
                QVERIFY2(isAsFar(k, corner[0], corner[1]) && isAsFar(k, corner[1], corner[2]),
                         qPrintable(faultOfSeed(number, "corner " + std::to_string(k))));
            }
            for (std::uint32_t k = 0; k < cells.trace.crossings.size(); ++k) {
                const std::uint32_t halfEdge = cells.trace.crossings[k].halfEdge;
                QVERIFY2(isAsFar(cells.numbers.crossings + k, delaunay.origin(halfEdge), targetOf(delaunay, halfEdge)),
                         qPrintable(faultOfSeed(number, "crossing " + std::to_string(k))));
            }
        }
    }
};

RUBBLE_TEST(PartitionPointsTest)
#include "PartitionPointsTest.moc"
