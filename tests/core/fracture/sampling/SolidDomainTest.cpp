// Tests core/fracture/sampling/SolidDomain.cpp, core/fracture/sampling/SolidScatter.cpp and
// core/fracture/sampling/SolidSurface.cpp.
#include "core/fracture/sampling/SolidDomain.h"

#include "core/base/math/Trigonometry.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/SolidSeeds.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <limits>

using namespace rubble;
using namespace rubble::test;

namespace {

/// The mean number of attempts of a point: one draws four random numbers.
double attemptsPerPoint(const SolidDomain& domain, std::uint64_t randomSeed) {
    constexpr int kPoints = 300;
    Random random(randomSeed);
    for (int k = 0; k < kPoints; ++k) domain.point(random);
    const std::uint64_t next = random.next();
    Random again(randomSeed);
    int draws = 0;
    while (again.next() != next) ++draws;
    return draws / 4.0 / kPoints;
}

}  // namespace

class SolidDomainTest : public QObject {
    Q_OBJECT
private slots:
    void boundsVolumeAndDepthAreThoseOfTheMesh() {
        const SolidDomain cube = domainOf(boxMeshOf({0, 0, 0}, {2, 3, 4}));
        QCOMPARE(cube.volume(), 24.0);
        QCOMPARE(cube.surface().area(), 52.0);
        QCOMPARE(cube.bounds(), (Box3{{0, 0, 0}, {2, 3, 4}}));
        QCOMPARE(cube.depth({1.0, 1.0, 0.25}), 0.25);
        QCOMPARE(cube.depth({1.0, 1.5, 2.0}), 1.0);
        QCOMPARE(cube.depth({5.0, 7.0, 2.0}), -5.0);
        QCOMPARE(cube.depth({1.0, 1.0, 0.0}), 0.0);
        QVERIFY(cube.contains({0.0, 0.0, 0.0}) && !cube.contains({-1e-300, 0.0, 0.0}));
    }
    void pointsOfAllShapesAreInside() {
        for (const auto& [name, mesh] : solidShapes()) {
            const SolidDomain domain = domainOf(mesh);
            Random random(7);
            for (int k = 0; k < 500; ++k) QVERIFY2(domain.contains(domain.point(random)), name);
        }
    }
    void fewPointsMissThinShapes() {
        for (const auto& [name, mesh] : solidShapes()) {
            const double attempts = attemptsPerPoint(domainOf(mesh), 3);
            qInfo("%s: %.2f attempts", name, attempts);
            QVERIFY2(attempts < 5.0, name);
        }
    }
    void pointsAreUniform() {
        // A torus turned: as many points on each side of its axis' planes, and in the halves by volume of its tube.
        const SolidDomain domain = domainOf(torus(60, 40));
        Random random(5);
        int right = 0, above = 0, front = 0;
        constexpr int kPoints = 10'000;
        for (int k = 0; k < kPoints; ++k) {
            const Vec3 point = domain.point(random);
            right += point.x > 0.0, front += point.y > 0.0, above += point.z > 0.0;
        }
        for (const int half : {right, above, front}) QVERIFY(std::abs(half - kPoints / 2) < 250);  // five deviations
    }
    void pointsNearACentreAreInsideAndNear() {
        for (const auto& [name, mesh] : solidShapes()) {
            const SolidDomain domain = domainOf(mesh);
            Random random(9);
            const double radius = 0.05 * domain.bounds().diagonal();
            for (int k = 0; k < 100; ++k) {
                const Vec3 centre = domain.point(random);
                const std::optional<Vec3> point = domain.pointNear(centre, radius, random);
                QVERIFY2(point && domain.contains(*point) && glm::distance(*point, centre) <= radius, name);
            }
            QVERIFY2(!domain.pointNear(domain.bounds().max + 2.0 * radius, radius, random), name);
        }
    }
    void sameRandomNumbersGiveSamePoints() {
        for (const auto& [name, mesh] : solidShapes()) {
            const SolidDomain one = domainOf(mesh), other = domainOf(mesh);
            Random first(1), second(1);
            for (int k = 0; k < 50; ++k) QCOMPARE(one.point(first), other.point(second));
        }
    }
    void densityIsFollowed() {
        // Proportional to x in the unit cube: a quarter of the points have x below a half.
        const SolidDomain cube = domainOf(boxMeshOf({0, 0, 0}, {1, 1, 1}));
        const SolidDensity density{[](Vec3 point) { return point.x; }, [](const Box3& box) { return box.max.x; }};
        const SolidScatter scatter = SolidScatter::of(cube.surface(), density).value();
        Random random(2);
        int low = 0;
        for (int k = 0; k < 4000; ++k) low += scatter.point(random).x < 0.5;
        QVERIFY(std::abs(low - 1000) < 140);  // five standard deviations
        const SolidDensity none{[](Vec3) { return 0.0; }, [](const Box3&) { return 0.0; }};
        QVERIFY(SolidScatter::of(cube.surface(), none).value().isEmpty());
    }
    void wrongMeshesAreRefused() {
        QCOMPARE(errorText(SolidDomain::of({})), "The mesh has no triangles.");
        TriangleMesh mesh = boxMeshOf({0, 0, 0}, {1, 1, 1});
        QCOMPARE(errorText(SolidDomain::of(insideOut(mesh))),
                 "The mesh encloses no volume: turn its triangles outward.");
        mesh.points[3].y = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(errorText(SolidDomain::of(mesh)), "Point 3 of the mesh is not finite or too far out.");
    }
    void cancelledDomainsStop() {
        TaskContext task;
        task.cancel.cancel();
        QCOMPARE(SolidDomain::of(bumpySphere(20), task).error().code, ErrorCode::Cancelled);
    }
};

RUBBLE_TEST(SolidDomainTest)
#include "SolidDomainTest.moc"
