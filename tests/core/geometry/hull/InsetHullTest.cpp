#include "core/base/Random.h"
#include "core/geometry/hull/ConvexHull.h"
#include "core/geometry/hull/InsetHull.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/hull/SimplifiedHull.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

using namespace rubble;

namespace {

/// Random points, many of them on a circle of radius 1 m, some nearly together.
Ring randomPoints(Random& random) {
    // Points of the unit circle by half-angle tangents, which are rational.
    std::set<double> tangents;
    const std::size_t count = 3 + random.below(8);
    while (tangents.size() < count) {
        const double tangent = 8.0 * random.unit() - 4.0;
        tangents.insert(tangent);
        if (random.below(3) == 0) tangents.insert(tangent + 1e-3 * random.unit());
    }
    Ring ring;
    for (const double t : tangents)
        ring.push_back(Vec2((1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t)) *
                       (random.below(3) > 0 ? 1.0 : 0.01 + 2.0 * random.unit()));
    return ring;
}

/// The prism over the convex hull of some points, from corner to corner, with plain signs.
Polytope randomPrism(Random& random) {
    const Ring points = randomPoints(random);
    Ring hull;
    Vec2 at = *std::ranges::min_element(points, lexicographicLess);
    const Vec2 first = at;
    do {
        hull.push_back(at);
        Vec2 next = points[0] == at ? points[1] : points[0];
        for (const Vec2 point : points) {
            if (point != at && cross(next - at, point - at) < 0.0) next = point;
        }
        at = next;
    } while (at != first && hull.size() <= points.size());
    const double depth = 0.002 + random.unit();
    return extruded(hull, -depth / 2.0, depth / 2.0);
}

double distanceInside(const Polytope& polytope, Vec3 point) {
    double least = 1e308;
    for (const Plane& plane : polytope.planes) least = std::min(least, plane.offset - glm::dot(plane.normal, point));
    return least;
}

/// The same as thinnestWidth(), by the distances of all corners from all sides.
double thinnestOfAll(const Polytope& prism) {
    double thinnest = std::numeric_limits<double>::infinity();
    for (const Plane& plane : prism.planes) {
        double width = 0.0;
        for (const Vec3& corner : prism.vertices)
            width = std::max(width, plane.offset - glm::dot(plane.normal, corner));
        thinnest = std::min(thinnest, width);
    }
    return thinnest;
}

}  // namespace

class InsetHullTest : public QObject {
    Q_OBJECT
private slots:
    void boxShrinksOnAllSides() {
        const Polytope box = extruded(Ring{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, -0.5, 0.5);
        const InsetHull hull = insetHull(box, 1e-3);
        QCOMPARE(hull.inset, 1e-3);
        QCOMPARE(hull.polytope.vertices.size(), std::size_t{8});
        QVERIFY(glm::distance(hull.polytope.vertices[0], Vec3(1e-3, 1e-3, 0.499)) < 1e-15);
        QVERIFY(std::abs(massOf(hull.polytope).volume - 1.998 * 0.998 * 0.998) < 1e-13);
        QVERIFY(insetHull(box, 0.0) == (InsetHull{box, 0.0}));
    }
    void thinSolidsShrinkByAHundredthAtMost() {
        const Polytope pane = extruded(Ring{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, -0.0025, 0.0025);
        QVERIFY(std::abs(insetHull(pane, 1e-3).inset - 5e-5) < 1e-18);
        QVERIFY(std::abs(thinnestWidth(extruded(Ring{{0, 0}, {3, 0}, {0, 4}}, 0.0, 9.0)) - 2.4) < 1e-15);
    }
    void thinnestWidthIsThatOfAllSidesAndCorners() {
        for (std::uint64_t seed = 0; seed < 3000; ++seed) {
            Random random(seed);
            Ring ring;
            const Polytope flat = randomPrism(random);
            for (std::size_t k = 0; 2 * k < flat.vertices.size(); ++k) ring.push_back(Vec2(flat.vertices[k]));
            const Polytope prism = extruded(ring, -2.0, 2.0);
            const double expected = thinnestOfAll(prism);
            QVERIFY2(std::abs(thinnestWidth(prism) - expected) <= 1e-14, std::to_string(seed).c_str());
        }
    }
    void shortSidesVanish() {
        // The corner at (2, 1) is cut off by a side of 0.14 mm.
        const Polytope cut = extruded(Ring{{0, 0}, {2, 0}, {2, 0.9999}, {1.9999, 1}, {0, 1}}, 0.0, 1.0);
        const InsetHull hull = insetHull(cut, 1e-3);
        QCOMPARE(hull.polytope.vertices.size(), std::size_t{8});
        QVERIFY(glm::distance(hull.polytope.vertices[2], Vec3(1.999, 0.999, 0.999)) < 1e-12);
    }
    void randomPrismsAreInsideByTheInset() {
        std::size_t vanished = 0;
        for (std::uint64_t seed = 0; seed < 3000; ++seed) {
            Random random(seed);
            const Polytope prism = randomPrism(random);
            const InsetHull hull = insetHull(prism, 1e-3 * random.unit());
            const std::string name = std::to_string(seed);
            QVERIFY2(!verifyPolytope(hull.polytope), name.c_str());
            QVERIFY2(hull.inset <= kMaxInset * thinnestWidth(prism), name.c_str());
            vanished += hull.polytope.vertices.size() < prism.vertices.size();
            double nearest = 1e308;
            for (const Vec3& vertex : hull.polytope.vertices) {
                nearest = std::min(nearest, distanceInside(prism, vertex));
                QVERIFY2(distanceInside(prism, vertex) >= hull.inset - 1e-10, name.c_str());
            }
            QVERIFY2(nearest <= hull.inset + 1e-10, name.c_str());
            // Nothing more than the inset was taken: a ball of that radius around the hull's corners reaches out.
            const Polytope solid = solidOf(hull).value();
            for (const Vec3& vertex : prism.vertices) QVERIFY2(distanceInside(solid, vertex) >= -1e-10, name.c_str());
            QVERIFY2(massOf(solid).volume <= massOf(prism).volume * (1.0 + 1e-3), name.c_str());
        }
        QVERIFY(vanished > 20);
    }
    void solidIsThePrismAgain() {
        const Polytope box = extruded(Ring{{0, 0}, {2, 0}, {1.5, 1}, {0, 1}}, -0.5, 0.5);
        const Polytope solid = solidOf(insetHull(box, 1e-3)).value();
        for (std::size_t k = 0; k < box.vertices.size(); ++k)
            QVERIFY(glm::distance(solid.vertices[k], box.vertices[k]) < 1e-14);
    }
    void solidsThinnerThanSinglePrecisionAreKept() {
        const auto wedge = [](double x, double height) {
            return convexHull(std::vector<Vec3>{{x, 0.0, 0.0}, {x + 0.5, 0.0, 0.0}, {x, 0.5, 0.0}, {x, 0.0, height}})
                .value();
        };
        QVERIFY(insetHull(wedge(0.5, 0.25), 1e-4).inset == 1e-4);
        const Polytope thin = wedge(0.5, 3.5e-8);
        QVERIFY((insetHull(thin, 1e-4) == InsetHull{thin, 0.0}));
    }
    void onlyPrismsArePrisms() {
        const Polytope box = extruded(Ring{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, -0.5, 0.5);
        QVERIFY(isPrism(box));
        Polytope turned = box;
        std::ranges::rotate(turned.faces[0], turned.faces[0].begin() + 1);
        QVERIFY(isPrism(turned));
        std::ranges::reverse(turned.faces[0]);
        QVERIFY(!isPrism(turned));
        // Not by its vertices, but by its planes.
        const std::optional<Polytope> solid = solidOf({turned, 1e-4});
        QVERIFY(solid && std::abs(massOf(*solid).volume - 2.0002 * 1.0002 * 1.0002) < 1e-12);
        Polytope frustum = box;
        frustum.vertices[0].x += 0.1;
        QVERIFY(!isPrism(frustum));
    }
    /// Moved faces split corners at which more than three meet; a hull of few corners keeps few.
    void insetHullsHaveFewCorners() {
        Random random(7);
        std::vector<Vec3> points;
        while (points.size() < kMaxCollisionCorners) {
            const Vec3 point{random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
            if (glm::length(point) > 0.1 && glm::length(point) < 1.0) points.push_back(glm::normalize(point));
        }
        const Polytope hull = convexHull(points).value();
        QCOMPARE(hull.vertices.size(), kMaxCollisionCorners);
        const InsetHull inset = insetHull(hull, 1e-3);
        QCOMPARE(inset.inset, 1e-3);
        QVERIFY(inset.polytope.vertices.size() <= kMaxCollisionCorners);
        QVERIFY(!verifyPolytope(inset.polytope));
        for (const Vec3& vertex : inset.polytope.vertices) {
            for (const Plane& plane : hull.planes)
                QVERIFY(glm::dot(plane.normal, vertex) <= plane.offset - 1e-3 + 1e-6);
        }
        QVERIFY(massOf(inset.polytope).volume > 0.98 * massOf(hull).volume);
    }
};

RUBBLE_TEST(InsetHullTest)
#include "InsetHullTest.moc"
