#include "editor/canvas/painting/VoronoiEdges.h"
#include "tests/support/Closeness.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

const Box2 kBox{{-1.0, -1.0}, {2.0, 2.0}};

}  // namespace

class VoronoiEdgesTest : public QObject {
    Q_OBJECT
private slots:
    void triangleHasThreeRaysFromItsCircumcentre() {
        const std::vector<Vec2> seeds = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
        const auto lines = voronoiEdges(*triangulate(seeds), kBox);
        QCOMPARE(lines.size(), std::size_t{3});
        for (const auto& [from, to] : lines) {
            QVERIFY(isWithinDistance(from, {0.5, 0.5}, 1e-12) || isWithinDistance(to, {0.5, 0.5}, 1e-12));
            const Vec2 end = isWithinDistance(from, {0.5, 0.5}, 1e-12) ? to : from;
            QVERIFY(isWithinDistance(end, {0.5, -1.0}, 1e-12) || isWithinDistance(end, {-1.0, 0.5}, 1e-12) ||
                    isWithinDistance(end, {2.0, 2.0}, 1e-12));
        }
    }
    void twoSeedsHaveTheBisector() {
        const std::vector<Vec2> seeds = {{0.0, 0.0}, {1.0, 0.0}};
        const auto lines = voronoiEdges(*triangulate(seeds), kBox);
        QCOMPARE(lines.size(), std::size_t{1});
        QVERIFY(std::abs(lines[0][0].x - 0.5) < 1e-12 && std::abs(lines[0][1].x - 0.5) < 1e-12);
        QVERIFY(std::abs(std::abs(lines[0][0].y - lines[0][1].y) - 3.0) < 1e-12);
    }
    void circumcirclePassesThroughTheCorners() {
        const std::vector<Vec2> seeds = {{0.3, 0.1}, {1.7, 0.4}, {0.9, 1.6}};
        const Delaunay delaunay = *triangulate(seeds);
        int circles = 0;
        for (std::uint32_t triangle = 0; triangle < delaunay.triangles.size(); ++triangle) {
            const std::optional<Circle> circle = circumcircle(delaunay, triangle);
            if (!circle) continue;
            ++circles;
            for (const Vec2 seed : seeds) {
                const Vec2 arm = seed - circle->centre;
                QVERIFY(std::abs(std::hypot(arm.x, arm.y) - circle->radius) < 1e-12);
            }
        }
        QCOMPARE(circles, 1);
    }
};

RUBBLE_TEST(VoronoiEdgesTest)
#include "VoronoiEdgesTest.moc"
