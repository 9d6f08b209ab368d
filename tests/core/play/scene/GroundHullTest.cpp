#include "core/play/scene/GroundHull.h"

#include "core/physics/world/World.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <glm/gtc/quaternion.hpp>

using namespace rubble;

namespace {

constexpr double kDt = 1.0 / 60.0;      // s
constexpr double kRounding = 1.2e-7;    // of single precision, relative
constexpr double kContactDepth = 1e-3;  // m, that bodies at rest may sink

/// A cube in a world with the ground.
struct GroundedCube {
    World world{WorldSettings{.gravity = {0.0, -9.81, 0.0}}};
    BodyId cube;

    GroundedCube(double side, Vec3 at, const Quat& orientation, Vec3 velocity) {
        const auto ground = groundHull();
        const auto shapeOf = [](const Polytope& hull) { return *makeShape({&hull, 1}); };
        if (!world.addBody({.shape = shapeOf(*ground), .kind = BodyKind::Static, .friction = 0.5}))
            qFatal("The ground cannot be a body.");
        cube = *world.addBody({.shape = shapeOf(test::boxOf(Vec3(side))),
                               .pose = {at, orientation},
                               .velocity = velocity,
                               .density = 1000.0,
                               .friction = 0.5});
    }
    void simulate(double seconds) {
        for (int k = 0; k < seconds / kDt; ++k) world.step(kDt);
    }
    Vec3 centre() const { return world.state(cube).centre; }
};

const Quat kTurned = glm::angleAxis(0.7, Vec3(0.0, 1.0, 0.0));

void addPlaces() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("z");
    QTest::newRow("origin") << 0.0 << 0.0;
    QTest::newRow("199.9 m") << 199.9 << 0.0;
    QTest::newRow("240 m") << 240.0 << -240.0;
    QTest::newRow("1 km") << 1000.0 << -1000.0;
    QTest::newRow("5 km") << 5000.0 << 100.0;
    QTest::newRow("90 km") << 9e4 << 9e4;
    QTest::newRow("-90 km") << -9e4 << 12.3;
}

/// What single precision may change at a place in each of some steps, m.
double roundingAt(double x, double z, int steps = 1) { return steps * kRounding * std::max(std::abs(x), std::abs(z)); }

}  // namespace

class GroundHullTest : public QObject {
    Q_OBJECT
private slots:
    void groundLiesBelowZero() {
        double top = -1e9, least = 1e9;
        const auto ground = groundHull();
        for (const Vec3& vertex : ground->vertices) {
            top = std::max(top, vertex.y);
            least = std::min({least, std::abs(vertex.x), std::abs(vertex.z)});
        }
        QCOMPARE(top, 0.0);
        QVERIFY(least > kMaxCoordinate);
    }
    void cubesStand_data() { addPlaces(); }
    void cubesStand() {
        QFETCH(double, x);
        QFETCH(double, z);
        GroundedCube cube(1.0, {x, 0.5, z}, kTurned, Vec3(0.0));
        cube.simulate(2.0);
        const Vec3 end = cube.centre();
        QVERIFY2(std::abs(end.y - 0.5) < kContactDepth, QByteArray::number(end.y));
        QVERIFY(glm::distance(Vec2(x, z), Vec2(end.x, end.z)) <= kContactDepth + roundingAt(x, z));
        QCOMPARE(cube.world.counts().awake, 0);
    }
    void cubesLand_data() { addPlaces(); }
    void cubesLand() {
        QFETCH(double, x);
        QFETCH(double, z);
        GroundedCube cube(1.0, {x, 2.5, z}, kTurned, Vec3(0.0));
        cube.simulate(3.0);
        const Vec3 end = cube.centre();
        QVERIFY2(std::abs(end.y - 0.5) < kContactDepth, QByteArray::number(end.y));
        QCOMPARE(cube.world.counts().awake, 0);
    }
    /// v² / (2 μ g) = 1.631 m.
    void boxesSlide_data() { addPlaces(); }
    void boxesSlide() {
        QFETCH(double, x);
        QFETCH(double, z);
        GroundedCube box(0.3, {x, 0.15, z}, {1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 4.0});
        box.simulate(2.0);
        const Vec3 end = box.centre();
        const double rounding = roundingAt(x, z, 60);  // while it moves
        QVERIFY2(std::abs(end.y - 0.15) < kContactDepth, QByteArray::number(end.y));
        QVERIFY2(std::abs(end.z - z - 1.631) < 0.05 + rounding, QByteArray::number(end.z - z));
        QVERIFY2(std::abs(end.x - x) < 0.01 + rounding, QByteArray::number(end.x - x));
    }
    void raysAndHullsMeetIt_data() { addPlaces(); }
    void raysAndHullsMeetIt() {
        QFETCH(double, x);
        QFETCH(double, z);
        const GroundedCube cube(1.0, {x, 0.5, z + 20.0}, kTurned, Vec3(0.0));
        const std::optional<CastHit> ray = cube.world.castRay({x, 3.0, z}, {x + 1.0, -1.0, z});
        QVERIFY(ray && std::abs(ray->point.y) < 1e-5 + roundingAt(x, z));
        const Polytope box = test::boxOf(Vec3(0.4));
        const Quat turned = glm::angleAxis(0.9, glm::normalize(Vec3(0.3, 1.0, -0.4)));
        double lowest = 0.0;
        for (const Vec3& corner : box.vertices) lowest = std::min(lowest, (turned * corner).y);
        const std::optional<CastHit> hull = *cube.world.castHull(box, {{x, 2.0 - lowest, z}, turned}, {0.0, -4.0, 0.0});
        QVERIFY(hull && std::abs(hull->fraction - 0.5) < 1e-5 + roundingAt(x, z));
    }
};

RUBBLE_TEST(GroundHullTest)
#include "GroundHullTest.moc"
