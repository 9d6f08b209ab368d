#include "core/play/scene/Projectile.h"

#include "core/geometry/hull/Polytope.h"
#include "tests/support/TestProgram.h"

using namespace rubble;

class ProjectileTest : public QObject {
    Q_OBJECT
private slots:
    void projectileMatchesTheShot_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("box") << static_cast<int>(ProjectileKind::Box);
        QTest::newRow("ball") << static_cast<int>(ProjectileKind::Ball);
        QTest::newRow("plank") << static_cast<int>(ProjectileKind::Plank);
    }
    void projectileMatchesTheShot() {
        QFETCH(int, kind);
        for (const Vec3 direction :
             {Vec3(0.0, 0.0, -1.0), Vec3(1.0, 2.0, 3.0), Vec3(0.0, 1.0, 0.0), Vec3(0.0, -1.0, 0.0)}) {
            const Throw thrown{.kind = static_cast<ProjectileKind>(kind),
                               .size = {0.4, 0.2, 1.0},
                               .mass = 7.0,
                               .from = {1.0, 2.0, 3.0},
                               .to = Vec3(1.0, 2.0, 3.0) + direction,
                               .speed = 5.0};
            const Result<BodyDefinition> body = projectileBody(thrown, nullptr, nullptr);
            QVERIFY(body.hasValue());
            QVERIFY(std::abs(body->density * body->shape->mass.volume - 7.0) < 1e-9);
            QVERIFY(glm::distance(body->velocity, 5.0 * direction / glm::length(direction)) < 1e-9);
            QVERIFY(glm::distance(body->pose.position, Vec3(1.0, 2.0, 3.0)) < 1e-9);
            const Vec3 forwards = body->pose.orientation * Vec3(0.0, 0.0, -1.0);
            QVERIFY(glm::distance(forwards, direction / glm::length(direction)) < 1e-9);
            QVERIFY(std::abs((body->pose.orientation * Vec3(1.0, 0.0, 0.0)).y) < 1e-9);
            QVERIFY(!verifyPolytope(projectileHull(thrown)));
        }
    }
    void invalidProjectileIsRejected() {
        for (const double mass : {1e-12, 1e20}) {
            const Result<BodyDefinition> body = projectileBody({.mass = mass}, nullptr, nullptr);
            QVERIFY(!body);
            QCOMPARE(body.error().message, std::string("The projectile is too light or too heavy to be simulated."));
        }
    }
};

RUBBLE_TEST(ProjectileTest)
#include "ProjectileTest.moc"
