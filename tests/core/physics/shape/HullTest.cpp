#include "core/physics/shape/Hull.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

#include <algorithm>

using namespace rubble;
using namespace rubble::test;

namespace {

/// A box with sides of 2, 4 and 6 m about the origin.
Hull brick() { return hullOf(boxOf({2.0, 4.0, 6.0})); }

bool isNear(Vec3f a, Vec3f b) { return length(a - b) < 1e-6f; }

}  // namespace

class HullTest : public QObject {
    Q_OBJECT
private slots:
    void boxHasCornersFacesAndEdges() {
        const Hull hull = brick();
        QCOMPARE(hull.cornerCount, 8);
        QCOMPARE(hull.planes.size(), std::size_t{6});
        QCOMPARE(hull.edges.size(), std::size_t{12});
        QCOMPARE(hull.loops.size(), std::size_t{24});
        QCOMPARE(hull.firstInLoop.size(), std::size_t{7});
        for (int face = 0; face < 6; ++face) QCOMPARE(hull.face(face).size(), std::size_t{4});
    }
    void hullTakesNoMoreMemoryThanItNeeds() {
        const Hull hull = hullOf(boxOf({2.0, 4.0, 6.0}));
        const auto isTight = [](const auto& values) { return values.capacity() == values.size(); };
        QVERIFY(isTight(hull.planes) && isTight(hull.edges) && isTight(hull.loops));
        QVERIFY(isTight(hull.firstInLoop) && isTight(hull.sides));
        for (const VectorRows* rows :
             {&hull.corners, &hull.edgeVectors, &hull.edgeCorners, &hull.edgeFirstNormals, &hull.edgeSecondNormals})
            QVERIFY(isTight(rows->x) && isTight(rows->y) && isTight(rows->z));
    }
    void measuresOfABox() {
        const Hull hull = brick();
        QVERIFY(isNear(hull.middle, Vec3f(0.0f)));
        QVERIFY(isNear(hull.extents, Vec3f(1.0f, 2.0f, 3.0f)));
        QCOMPARE(hull.minWidth, 2.0f);
        QVERIFY(std::abs(hull.boundingRadius - std::sqrt(14.0f)) < 1e-6f);
        QVERIFY(std::abs(hull.innerRadius - 0.999999f) < 1e-7f);  // a micrometre less, for merged faces
    }
    /// Relative to a centre of mass that lies 0.75 m nearer to the side at x = 1.
    void cornersAreRelativeToTheCentre() {
        const Hull hull = *makeHull(boxOf({2.0, 4.0, 6.0}), Vec3(0.75, 0.0, 0.0));
        QVERIFY(isNear(hull.middle, Vec3f(-0.75f, 0.0f, 0.0f)));
        QVERIFY(std::abs(hull.innerRadius - 0.249999f) < 1e-7f);
        QVERIFY(std::abs(hull.boundingRadius - std::sqrt(1.75f * 1.75f + 13.0f)) < 1e-6f);
        for (const HullPlane& plane : hull.planes) {
            if (plane.normal.x > 0.5f) QVERIFY(std::abs(plane.offset - 0.25f) < 1e-6f);
            if (plane.normal.x < -0.5f) QVERIFY(std::abs(plane.offset - 1.75f) < 1e-6f);
        }
    }
    /// As in a shape of several hulls: no sphere about the common centre lies within.
    void centreOutsideHasNoInnerRadius() {
        const Hull hull = *makeHull(boxOf({2.0, 4.0, 6.0}), Vec3(5.0, 0.0, 0.0));
        QCOMPARE(hull.innerRadius, -hull.boundingRadius);
    }
    void facesWindCounterClockwise() {
        const Hull hull = brick();
        for (int face = 0; face < 6; ++face) {
            const auto loop = hull.face(face);
            const Vec3f a = hull.corner(loop[0]), b = hull.corner(loop[1]), c = hull.corner(loop[2]);
            QVERIFY(isNear(normalized(cross(b - a, c - b)), hull.planes[face].normal));
        }
    }
    /// The plane of each side contains its edge and faces away from the middle of the face.
    void sidesBoundTheirFace() {
        const Hull hull = brick();
        for (int face = 0; face < 6; ++face) {
            const auto loop = hull.face(face);
            const auto sides = hull.sidesOf(face);
            const Vec3f centre = hull.planes[face].normal * hull.planes[face].offset;
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Vec3f from = hull.corner(loop[i]), to = hull.corner(loop[(i + 1) % loop.size()]);
                QVERIFY(std::abs(dot(sides[i].normal, from) - sides[i].offset) < 1e-6f);
                QVERIFY(std::abs(dot(sides[i].normal, to) - sides[i].offset) < 1e-6f);
                QVERIFY(std::abs(dot(sides[i].normal, hull.planes[face].normal)) < 1e-6f);
                QVERIFY(dot(sides[i].normal, centre) < sides[i].offset - 0.5f);
            }
        }
    }
    void rowsOfEdgesMatchTheEdges() {
        const Hull hull = hullOf(boxOf({2.0, 4.0, 6.0}));
        for (std::size_t edge = 0; edge < hull.edges.size(); ++edge) {
            const auto& [from, to, firstFace, secondFace] = hull.edges[edge];
            const auto at = [&](const VectorRows& rows) { return Vec3f(rows.x[edge], rows.y[edge], rows.z[edge]); };
            QVERIFY(at(hull.edgeCorners) == hull.corner(from));
            QVERIFY(at(hull.edgeVectors) == hull.corner(to) - hull.corner(from));
            QVERIFY(at(hull.edgeFirstNormals) == hull.planes[firstFace].normal);
            QVERIFY(at(hull.edgeSecondNormals) == hull.planes[secondFace].normal);
            // The edge runs along the loop of its first face.
            const auto loop = hull.face(firstFace);
            const auto place = std::ranges::find(loop, from) - loop.begin();
            QCOMPARE(loop[static_cast<std::size_t>(place + 1) % loop.size()], to);
        }
    }
    void farthestCornerAndFace() {
        const Hull hull = brick();
        QVERIFY(hull.corner(hull.farthest(Vec3f(1.0f, -1.0f, 1.0f))) == Vec3f(1.0f, -2.0f, 3.0f));
        QVERIFY(isNear(hull.planes[hull.faceAlong(Vec3f(0.1f, -0.9f, 0.2f))].normal, Vec3f(0.0f, -1.0f, 0.0f)));
    }
    void tiesGoToTheFirst() {
        const Hull hull = brick();
        int first = 0;
        while (hull.corner(first).x < 0.0f) ++first;
        QCOMPARE(hull.farthest(Vec3f(1.0f, 0.0f, 0.0f)), first);
        QCOMPARE(hull.farthest(Vec3f(0.0f)), 0);
        QCOMPARE(hull.faceAlong(Vec3f(0.0f)), 0);
    }
    /// A thousandth of a metre, or 2 % of the width where that is less.
    void nearCornersAreWelded() {
        const auto cornersOf = [](double size, double distance) {
            std::vector<Vec3> points{{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
            points.push_back({size - 0.5 * distance, 0.5 * distance, 0.3 * distance});
            return hullOf(*convexHull(points)).cornerCount;
        };
        QCOMPARE(cornersOf(1.0, 0.0009), 4);
        QCOMPARE(cornersOf(1.0, 0.05), 5);
        QCOMPARE(cornersOf(0.01, 0.0009), 5);
    }
    void tooManyCornersAreRefused() {
        std::vector<Vec2> circle;
        for (int k = 0; k < 129; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / 129.0;
            circle.push_back({10.0 * cosine(angle), 10.0 * sine(angle)});
        }
        const Result<Hull> hull = makeHull(extruded(circle, 0.0, 1.0), Vec3(0.0));
        QVERIFY(!hull);
        QCOMPARE(hull.error().code, ErrorCode::BadInput);
        QCOMPARE(hull.error().message, "The hull has 258 corners; the simulation supports at most 256.");
        circle.pop_back();
        QVERIFY(makeHull(extruded(circle, 0.0, 1.0), Vec3(0.0)));
    }
    void flatHullsAreRefused() {
        Polytope triangle;
        triangle.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        triangle.faces = {{0, 1, 2}, {2, 1, 0}};
        const Result<Hull> hull = makeHull(triangle, Vec3(0.0));
        QVERIFY(!hull);
        QCOMPARE(hull.error().code, ErrorCode::Degenerate);
        QCOMPARE(hull.error().message, "The hull needs at least four corners and four faces, but has 3 and 2.");
    }
};

RUBBLE_TEST(HullTest)
#include "HullTest.moc"
