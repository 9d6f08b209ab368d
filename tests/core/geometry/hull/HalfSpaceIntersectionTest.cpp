#include "core/geometry/hull/HalfSpaceIntersection.h"

#include "core/base/Random.h"
#include "core/geometry/hull/ConvexHull.h"
#include "core/geometry/hull/InsetHull.h"
#include "core/geometry/hull/MassProperties.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

namespace {

Polytope randomHull(Random& random) {
    std::vector<Vec3> points;
    for (int k = 0; k < 40; ++k)
        points.push_back({random.between(-1.0, 1.0), random.between(-0.5, 0.5), random.between(-2.0, 2.0)});
    return *convexHull(points);
}

}  // namespace

class HalfSpaceIntersectionTest : public QObject {
    Q_OBJECT
private slots:
    void sixPlanesMakeABox() {
        std::vector<Plane> planes;
        for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
            planes.push_back({axis, 2.0});
            planes.push_back({-axis, 1.0});
        }
        planes.push_back({glm::normalize(Vec3(1, 1, 1)), 20.0});  // beyond it
        const auto box = halfSpaceIntersection(planes, Vec3(0.5));
        QVERIFY(box);
        QCOMPARE(box->vertices.size(), std::size_t{8});
        QVERIFY(std::abs(massOf(*box).volume - 27.0) < 1e-9);
    }
    void pointsInFrontOfAPlaneHaveNone() {
        const std::vector<Plane> planes{{{1, 0, 0}, 1.0}, {{-1, 0, 0}, 1.0}, {{0, 1, 0}, 1.0}, {{0, 0, 1}, 1.0}};
        QVERIFY(!halfSpaceIntersection(planes, {2.0, 0.0, 0.0}));
        QVERIFY(!halfSpaceIntersection(planes, {0.0, 0.0, 0.0}));  // unbounded
    }
    void theFacesOfAHullGiveItBack() {
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            Random random(seed);
            const Polytope hull = randomHull(random);
            const auto again = halfSpaceIntersection(hull.planes, massOf(hull).centre);
            QVERIFY2(again && !verifyPolytope(*again), qPrintable(QString("seed %1").arg(seed)));
            QVERIFY(std::abs(massOf(*again).volume - massOf(hull).volume) < 1e-9);
            QCOMPARE(again->vertices.size(), hull.vertices.size());
        }
    }
    /// Also of hulls that are no prisms: valid, inside by the inset, and thinner by twice that.
    void hullsAreInset() {
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            Random random(seed);
            const Polytope hull = randomHull(random);
            const InsetHull inset = insetHull(hull, 1e-3);
            QCOMPARE(inset.inset, 1e-3);
            QCOMPARE(verifyPolytope(inset.polytope).value_or(""), std::string());
            for (const Plane& plane : hull.planes) {
                double front = -1e300;
                for (const Vec3& vertex : inset.polytope.vertices)
                    front = std::max(front, glm::dot(plane.normal, vertex) - plane.offset);
                QVERIFY(front <= -1e-3 + 2e-7);
            }
            const std::optional<Polytope> solid = solidOf(inset);
            QVERIFY(solid && std::abs(massOf(*solid).volume - massOf(hull).volume) < 1e-2 * massOf(hull).volume);
            QVERIFY(massOf(inset.polytope).volume > 0.9 * massOf(hull).volume);
            QVERIFY(std::abs(thinnestWidth(hull) - thinnestWidth(inset.polytope)) < 0.1);
        }
    }
};

RUBBLE_TEST(HalfSpaceIntersectionTest)
#include "HalfSpaceIntersectionTest.moc"
