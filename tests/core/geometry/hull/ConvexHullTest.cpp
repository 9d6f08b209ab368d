// Tests core/geometry/hull/ConvexHull.cpp and core/geometry/hull/HullTriangles.cpp.
#include "core/base/Random.h"
#include "core/geometry/hull/ConvexHull.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/predicates/Predicates.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

using namespace rubble;

namespace {

std::vector<Vec3> cubeCorners(double side) {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) corners.push_back({i & 1 ? side : 0.0, i & 2 ? side : 0.0, i & 4 ? side : 0.0});
    return corners;
}

std::string faultOf(const std::vector<Vec3>& points) {
    const Result<Polytope> hull = convexHull(points);
    return hull ? verifyPolytope(*hull).value_or("") : hull.error().message;
}

/// Whether no point lies outside any face, decided exactly.
bool containsAll(const Polytope& hull, const std::vector<Vec3>& points) {
    for (const auto& loop : hull.faces) {
        for (const Vec3& point : points) {
            if (orient3d(hull.vertices[loop[0]], hull.vertices[loop[1]], hull.vertices[loop[2]], point) < 0)
                return false;
        }
    }
    return true;
}

using IntegerPlane = std::array<long, 4>;

/// Brute-force oracle for integer points: every plane through three points with no point in front of it.
std::set<IntegerPlane> supportingPlanes(const std::vector<std::array<long, 3>>& points) {
    std::set<IntegerPlane> planes;
    for (const auto& a : points) {
        for (const auto& b : points) {
            for (const auto& c : points) {
                const long u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
                const long v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
                IntegerPlane plane{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0], 0};
                const long divisor = std::gcd(std::gcd(plane[0], plane[1]), plane[2]);
                if (divisor == 0) continue;
                for (int i = 0; i < 3; ++i) plane[i] /= divisor;
                const auto height = [&](const auto& p) { return plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2]; };
                plane[3] = height(a);
                if (std::all_of(points.begin(), points.end(), [&](const auto& p) { return height(p) <= plane[3]; })) {
                    planes.insert(plane);
                }
            }
        }
    }
    return planes;
}

}  // namespace

class ConvexHullTest : public QObject {
    Q_OBJECT
private slots:
    void nearlyFlatFacesAreMerged() {
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            Random random(seed);
            std::vector<Vec3> points;
            for (int k = 0; k < 60; ++k) {  // on the faces of a cube, up to rounding
                Vec3 point{random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
                point[k % 3] = (k % 2 == 0 ? 1.0 : -1.0) + random.between(-1e-13, 1e-13);
                points.push_back(point);
            }
            for (int k = 0; k < 8; ++k) points.push_back({k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0});
            const Result<Polytope> hull = convexHull(points, 1e-10);
            QVERIFY(hull);
            QCOMPARE(hull->faces.size(), std::size_t{6});
            QCOMPARE(hull->vertices.size(), std::size_t{8});
            QCOMPARE(verifyPolytope(translated(*hull, {0.1, 0.2, 0.3})).value_or(""), std::string());
        }
    }
    void cubeHasSixFacesDespiteOtherPoints() {
        std::vector<Vec3> points = cubeCorners(2.0);
        points.push_back({1.0, 1.0, 1.0});  // inside
        points.push_back({1.0, 1.0, 2.0});  // on a face
        points.push_back({1.0, 0.0, 0.0});  // on an edge
        points.push_back({2.0, 2.0, 2.0});  // a duplicate corner
        const Result<Polytope> hull = convexHull(points);
        QVERIFY(hull);
        QVERIFY(hull->vertices == cubeCorners(2.0));
        QCOMPARE(hull->edges.size(), std::size_t{12});
        const std::vector<std::vector<std::uint32_t>> faces = {{0, 1, 5, 4}, {0, 2, 3, 1}, {0, 4, 6, 2},
                                                               {1, 3, 7, 5}, {2, 6, 7, 3}, {4, 5, 7, 6}};
        QVERIFY(hull->faces == faces);
        QVERIFY(hull->planes[5] == (Plane{{0.0, 0.0, 1.0}, 2.0}));
        QCOMPARE(verifyPolytope(*hull).value_or(""), "");
        QCOMPARE(massOf(*hull).volume, 8.0);
    }
    void latticeOfPointsIsACube() {
        std::vector<Vec3> points;
        for (int x = 0; x < 6; ++x) {
            for (int y = 0; y < 6; ++y) {
                for (int z = 0; z < 6; ++z) points.push_back({x * 0.1, y * 0.1, z * 0.1});
            }
        }
        const Result<Polytope> hull = convexHull(points);
        QCOMPARE(hull->vertices.size(), std::size_t{8});
        QCOMPARE(hull->faces.size(), std::size_t{6});
        QCOMPARE(verifyPolytope(*hull).value_or(""), "");
    }
    void hullOfAPrismIsThePrism() {
        Ring ring;
        for (int i = 0; i < 7; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / 7.0;
            ring.push_back({std::cos(angle), std::sin(angle)});
        }
        const Polytope prism = extruded(ring, -0.25, 0.25);
        const Result<Polytope> hull = convexHull(prism.vertices);
        QVERIFY(hull->vertices == prism.vertices);
        QCOMPARE(hull->edges.size(), prism.edges.size());
        QCOMPARE(hull->faces.size(), prism.faces.size());
        QVERIFY(std::abs(massOf(*hull).volume - massOf(prism).volume) < 1e-15);
    }
    void pointOneUlpAboveAFaceAddsFaces() {
        std::vector<Vec3> points = cubeCorners(1.0);
        points.push_back({0.5, 0.5, std::nextafter(1.0, 2.0)});
        const Result<Polytope> hull = convexHull(points);
        QCOMPARE(hull->vertices.size(), std::size_t{9});
        QCOMPARE(hull->faces.size(), std::size_t{9});
        QCOMPARE(verifyPolytope(*hull).value_or(""), "");
    }
    void needlesHaveAccurateNormals() {
        std::vector<Vec3> points = cubeCorners(1.0);
        points.push_back({0.5, -0x1p-60, 1.0});           // just off the middle of an edge
        points.push_back({0.3, -0x1p-61, 0x1p-55});       // and of another
        points.push_back({1.0 + 0x1p-52, 0.7, 0x1p-54});  // and of a third
        QCOMPARE(faultOf(points), "");
        QVERIFY(containsAll(*convexHull(points), points));
    }
    void degeneratePointsAreRejected() {
        const auto fault = [](const std::vector<Vec3>& points) { return convexHull(points).error(); };
        QCOMPARE(fault({}).message, "A hull needs at least four points; there are 0.");
        QCOMPARE(fault({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).code, ErrorCode::BadInput);
        QCOMPARE(fault({{0, 0, 0}, {1, 0, 0}, {0, NAN, 0}, {0, 0, 1}}).message,
                 "Coordinate y of point 2 is not finite.");
        QCOMPARE(fault({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1e200}}).message,
                 "Coordinate z of point 3 is too large or too small to be exact.");
        QCOMPARE(fault({4, {1, 2, 3}}).message, "The 4 points lie at one point, so they have no convex hull.");
        QCOMPARE(fault({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {-3, -3, -3}}).message,
                 "The 4 points lie on one line, so they have no convex hull.");
        QCOMPARE(fault({{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {7, 3, 5}, {2, 2, 5}}).message,
                 "The 5 points lie in one plane, so they have no convex hull.");
        QCOMPARE(fault({4, {1, 2, 3}}).code, ErrorCode::Degenerate);
    }
    void orderOfPointsDoesNotMatter() {
        Random random(3);
        std::vector<Vec3> points;
        for (int i = 0; i < 60; ++i) points.push_back({random.unit(), random.unit(), random.unit()});
        const std::vector<Vec3> reversed(points.rbegin(), points.rend());
        const Result<Polytope> hull = convexHull(points);
        const Result<Polytope> other = convexHull(reversed);
        QVERIFY(std::vector<Vec3>(other->vertices.rbegin(), other->vertices.rend()) == hull->vertices);
        QCOMPARE(other->faces.size(), hull->faces.size());
        QVERIFY(std::abs(massOf(*hull).volume - massOf(*other).volume) < 1e-15);
    }
    void latticePointsMatchTheIntegerOracle() {
        const std::uint64_t seed = 11;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        for (int round = 0; round < 300; ++round) {
            std::vector<std::array<long, 3>> integers(4 + random.below(12));
            std::vector<Vec3> points;
            for (auto& p : integers) {
                for (long& coordinate : p) coordinate = static_cast<long>(random.below(4));
                points.push_back({static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
            }
            const Result<Polytope> hull = convexHull(points);
            const std::set<IntegerPlane> planes = supportingPlanes(integers);
            if (!hull) {
                QVERIFY(planes.size() <= 2);
                continue;
            }
            QCOMPARE(hull->faces.size(), planes.size());
            QCOMPARE(verifyPolytope(*hull).value_or(""), "");
            QVERIFY(containsAll(*hull, points));
        }
    }
    void randomPointsAreInsideTheirHull() {
        const std::uint64_t seed = 12;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        for (const int count : {10, 100, 1000, 5000}) {
            std::vector<Vec3> points;
            double largest = 0.0;
            for (int i = 0; i < count; ++i) {
                points.push_back({random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
                if (i % 2 == 0) points.back() = glm::normalize(points.back());
                largest = std::max(largest, glm::length(points.back()));
            }
            const Result<Polytope> hull = convexHull(points);
            QCOMPARE(verifyPolytope(*hull).value_or(""), "");
            QVERIFY(containsAll(*hull, points));
            QVERIFY(massOf(*hull).volume < 4.0 / 3.0 * std::numbers::pi * largest * largest * largest);
        }
    }
};

RUBBLE_TEST(ConvexHullTest)
#include "ConvexHullTest.moc"
