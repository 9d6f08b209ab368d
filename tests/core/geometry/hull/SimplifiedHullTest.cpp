// Tests core/geometry/hull/SimplifiedHull.cpp and core/geometry/hull/GrowingHull.cpp.
#include "core/geometry/hull/SimplifiedHull.h"

#include "core/base/Random.h"
#include "core/base/math/Trigonometry.h"
#include "core/geometry/hull/ConvexHull.h"
#include "core/geometry/hull/GrowingHull.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/search/Box3.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace rubble;
using namespace rubble::test;

namespace {

Vec3 onSphere(Random& random) {
    const double z = random.between(-1.0, 1.0), angle = random.between(0.0, 2.0 * std::numbers::pi);
    const double radius = std::sqrt(1.0 - z * z);
    return {radius * cosine(angle), radius * sine(angle), z};
}

Vec3 onCylinder(Random& random) {
    const double angle = random.between(0.0, 2.0 * std::numbers::pi);
    return {cosine(angle), sine(angle), random.below(2) == 0 ? -1.0 : 1.0};
}

Vec3 onBox(Random& random) {
    Vec3 point{random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
    point[static_cast<int>(random.below(3))] = random.below(2) == 0 ? -1.0 : 1.0;
    return point;
}

Polytope hullOfPoints(Vec3 (*pointOn)(Random&), Vec3 radii, int count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Vec3> points;
    for (int k = 0; k < count; ++k) points.push_back(radii * pointOn(random));
    return convexHull(points).value();
}

double diagonalOf(const Polytope& hull) {
    Box3 box;
    for (const Vec3& corner : hull.vertices) box.include(corner);
    return box.diagonal();
}

/// How far outside the faces of a hull the corners of another are at most, m.
double outsideFaces(const Polytope& hull, const Polytope& corners) {
    double most = 0.0;
    for (const Vec3& corner : corners.vertices) {
        for (const Plane& plane : hull.planes) most = std::max(most, glm::dot(plane.normal, corner) - plane.offset);
    }
    return most;
}

/// Checks a simplified hull against its own: valid, of some of its corners, and with none too far outside.
std::string faultOf(const Polytope& simplified, const Polytope& hull) {
    if (const std::optional<std::string> fault = verifyPolytope(simplified)) return *fault;
    if (simplified.vertices.size() > kMaxCollisionCorners) return "It has too many corners.";
    for (const Vec3& corner : simplified.vertices) {
        if (std::ranges::find(hull.vertices, corner) == hull.vertices.end()) return "It has a corner of its own.";
    }
    const double most = maxCollisionError(simplified.vertices.size(), diagonalOf(hull)),
                 outside = outsideFaces(simplified, hull);
    if (outside > most * (1.0 + 1e-9)) return "A corner is " + std::to_string(outside) + " m outside.";
    return {};
}

Polytope simplifiedForCollisions(const Polytope& hull) { return simplifiedHull(hull, collisionDetail(hull)); }

}  // namespace

class SimplifiedHullTest : public QObject {
    Q_OBJECT
private slots:
    void simplifiedHullsKeepTheirBounds() {
        const std::array<Vec3, 5> radii{Vec3(1.0), Vec3(0.05), {2.0, 1.0, 0.3}, {1.0, 1.0, 0.01}, {0.01, 0.01, 3.0}};
        for (Vec3 (*pointOn)(Random&) : {onSphere, onCylinder, onBox}) {
            for (const Vec3& radius : radii) {
                for (const int count : {8, 40, 300, 2000}) {
                    const Polytope hull = hullOfPoints(pointOn, radius, count, 5);
                    const Polytope simplified = simplifiedForCollisions(hull);
                    QCOMPARE(faultOf(simplified, hull), std::string());
                    const double lost = 1.0 - massOf(simplified).volume / massOf(hull).volume;
                    QVERIFY2(lost >= -1e-12 && lost < 0.1, qPrintable(QString::number(lost)));
                    if (simplified.vertices.size() < kMaxCollisionCorners) QVERIFY(lost < 0.02);  // two sides of 1 %
                }
            }
        }
    }
    void hullsWithoutDetailsStayAsTheyAre() {
        for (const Polytope& hull : {boxOf({1.0, 2.0, 3.0}), boxOf({1.0, 1.0, 1e-6}),
                                     hullOfPoints(onSphere, Vec3(1.0), 4, 1), hullOfPoints(onSphere, Vec3(1.0), 30, 2)})
            QVERIFY(simplifiedForCollisions(hull) == hull);
    }
    /// A cube whose corners are cut off by less than the tolerance, and by more.
    void detailsBelowTheToleranceVanish() {
        const auto chamfered = [](double width) {
            std::vector<Vec3> points;
            for (int corner = 0; corner < 8; ++corner) {
                for (int axis = 0; axis < 3; ++axis) {
                    Vec3 point{corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5};
                    point[axis] -= std::copysign(width, point[axis]);
                    points.push_back(point);
                }
            }
            return convexHull(points).value();
        };
        QCOMPARE(chamfered(0.01).vertices.size(), std::size_t{24});
        QCOMPARE(simplifiedForCollisions(chamfered(0.01)).vertices.size(), std::size_t{24});
        const Polytope simplified = simplifiedForCollisions(chamfered(0.9e-3));
        QVERIFY(simplified.vertices.size() < 20);
        QVERIFY(1.0 - massOf(simplified).volume < 6e-3);
    }
    void thinHullsKeepTheirWidth() {
        const Polytope foil = hullOfPoints(onCylinder, {1.0, 1.0, 1e-4}, 200, 3);
        QVERIFY(massOf(simplifiedForCollisions(foil)).volume > 0.95 * massOf(foil).volume);
    }
    void theLimitHolds() {
        const Polytope sphere = hullOfPoints(onSphere, Vec3(1.0), 2000, 4);
        for (const std::size_t most : {4u, 5u, 12u, 64u, 200u}) {
            const Polytope simplified = simplifiedHull(sphere, {.tolerance = 1e-6, .maxCorners = most});
            QCOMPARE(simplified.vertices.size(), most);
            QVERIFY(!verifyPolytope(simplified));
        }
    }
    void growingHullsAreThoseOfAllPoints() {
        const Polytope sphere = hullOfPoints(onSphere, Vec3(1.0), 60, 6);
        const HullSimplex simplex = firstSimplex(sphere.vertices).value();
        GrowingHull growing(sphere.vertices, simplex);
        for (std::uint32_t point = 0; point < sphere.vertices.size(); ++point) {
            if (std::ranges::find(simplex, point) != simplex.end()) continue;
            std::uint32_t face = 0;
            while (face < growing.faceCount() && !(growing.isAlive(face) && growing.sees(point, face))) ++face;
            QVERIFY(face < growing.faceCount());
            const std::uint32_t first = growing.add(point, face);
            QVERIFY(std::ranges::find(growing.replaced(), face) != growing.replaced().end());
            QVERIFY(!growing.isAlive(face) && growing.isAlive(first));
        }
        QCOMPARE(growing.triangles().size(), 2 * sphere.vertices.size() - 4);
        QVERIFY(!firstSimplex(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
    }
};

RUBBLE_TEST(SimplifiedHullTest)
#include "SimplifiedHullTest.moc"
