// Tests core/fracture/solid/FaceTriangulation.cpp.
#include "core/fracture/solid/FaceTriangulation.h"

#include "core/base/Random.h"
#include "core/base/math/Trigonometry.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <algorithm>
#include <map>

using namespace rubble;

namespace {

using Triangles = PointTriangles;

Triangles triangulated(const std::vector<Vec3>& points, const std::vector<PointLoop>& loops, Vec3 normal) {
    Triangles triangles;
    triangulateFace(points, loops, PlaneView(normal), 0.0, triangles);
    return triangles;
}

/// Whether the edges of triangles, less those of loops, come in opposite pairs.
bool fills(const Triangles& triangles, const std::vector<PointLoop>& loops) {
    std::map<std::array<std::uint32_t, 2>, int> balance;
    const auto add = [&](std::uint32_t a, std::uint32_t b, int count) {
        balance[{std::min(a, b), std::max(a, b)}] += a < b ? count : -count;
    };
    for (const auto& t : triangles) {
        for (int k = 0; k < 3; ++k) add(t[k], t[(k + 1) % 3], 1);
    }
    for (const PointLoop& loop : loops) {
        for (std::size_t k = 0; k < loop.size(); ++k) add(loop[k], loop[(k + 1) % loop.size()], -1);
    }
    return std::ranges::all_of(balance, [](const auto& entry) { return entry.second == 0; });
}

double areaOf(const std::vector<Vec3>& points, const Triangles& triangles, Vec3 normal) {
    double area = 0.0;
    for (const auto& [a, b, c] : triangles) {
        const double part = glm::dot(glm::cross(points[b] - points[a], points[c] - points[a]), normal) / 2.0;
        if (part < -1e-12) return -1.0;
        area += part;
    }
    return area;
}

/// A star of n corners, from angle to angle farther or nearer.
PointLoop addStar(std::vector<Vec3>& points, int n, double radius, Random& random, bool isHole) {
    PointLoop loop;
    for (int k = 0; k < n; ++k) {
        const double angle = 6.283185307179586 * k / n, r = radius * random.between(0.5, 1.0);
        loop.push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back({0.0, r * cosine(angle), r * sine(angle)});
    }
    if (isHole) std::ranges::reverse(loop);
    return loop;
}

}  // namespace

class FaceTriangulationTest : public QObject {
    Q_OBJECT
private slots:
    void convexFacesAreFans() {
        const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        Triangles triangles;
        QVERIFY(triangulateConvex(points, {0, 1, 2, 3}, PlaneView(Vec3(0, 0, 1)), triangles));
        QCOMPARE(triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
        triangles.clear();
        QVERIFY(triangulateConvex(points, {0, 3, 2, 1}, PlaneView(Vec3(0, 0, -1)), triangles));
        QCOMPARE(triangles.size(), 2u);
        QVERIFY(!triangulateConvex({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}}, {0, 1, 2, 3},
                                   PlaneView(Vec3(0, 0, 1)), triangles));
    }
    void starsWithHolesAreFilled() {
        Random random(1);
        const Vec3 normal(1, 0, 0);
        for (int n = 0; n < 300; ++n) {
            std::vector<Vec3> points;
            std::vector<PointLoop> loops = {addStar(points, 3 + n % 60, 4.0, random, false)};
            if (n % 2 == 1) loops.push_back(addStar(points, 3 + n % 7, 1.0, random, true));
            const bool areApart = loops.size() == 1 || loops[0].size() > 8;  // a coarse star may cross its hole
            const Triangles triangles = triangulated(points, loops, normal);
            QVERIFY(fills(triangles, loops));
            if (areApart) QVERIFY2(areaOf(points, triangles, normal) > 0.0, qPrintable(QString::number(n)));
        }
    }
    void straightCornersGetNoFlatTriangles() {
        std::vector<Vec3> points;
        PointLoop loop;
        for (int side = 0; side < 4; ++side) {
            for (int k = 0; k < 4; ++k) {
                const double along = k / 4.0;
                const Vec3 corner[] = {{along, 0, 0}, {1, along, 0}, {1 - along, 1, 0}, {0, 1 - along, 0}};
                loop.push_back(static_cast<std::uint32_t>(points.size()));
                points.push_back(corner[side]);
            }
        }
        const Triangles triangles = triangulated(points, {loop}, {0, 0, 1});
        QCOMPARE(triangles.size(), 14u);
        for (const auto& [a, b, c] : triangles) {
            QVERIFY(glm::length(glm::cross(points[b] - points[a], points[c] - points[a])) > 1e-3);
        }
        QVERIFY(fills(triangles, {loop}));
    }
    /// What rounding may leave: loops that cross themselves a little, or are no polygons at all.
    void anyLoopIsFilled() {
        Random random(2);
        for (int n = 0; n < 2000; ++n) {
            std::vector<Vec3> points;
            PointLoop loop;
            for (int k = 0; k < 4 + n % 40; ++k) {
                loop.push_back(static_cast<std::uint32_t>(k));
                points.push_back({0.0, static_cast<double>(random.below(6)), static_cast<double>(random.below(6))});
            }
            const Triangles triangles = triangulated(points, {loop}, {1, 0, 0});
            QCOMPARE(triangles.size(), loop.size() - 2);
            QVERIFY(fills(triangles, {loop}));
        }
    }
};

RUBBLE_TEST(FaceTriangulationTest)
#include "FaceTriangulationTest.moc"
