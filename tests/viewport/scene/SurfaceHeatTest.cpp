#include "tests/support/TestProgram.h"
#include "viewport/scene/SurfaceHeat.h"

#include "core/base/Random.h"
#include "core/physics/solver/SpeedThresholds.h"
#include "tests/support/editor/Sessions.h"
#include "viewport/scene/SessionSceneBuilder.h"

using namespace rubble;

namespace {

const Vec3 kOrigin{1000.0, -20.0, 400.0};

/// The computation of heat.glsl.
double heatOf(const SurfaceHeat& row, const HeatSource& source, glm::vec3 point, glm::vec3 normal) {
    const auto xyz = [](const glm::vec4& v) { return glm::vec3(v.x, v.y, v.z); };
    const glm::vec3 way = point - xyz(source.from), arm = point - xyz(row.centre);
    const float squared = source.gravity.w + 2.0f * glm::dot(xyz(source.gravity), way);
    if (squared <= 0.0f) return 0.0;
    const float speed = std::sqrt(squared);
    const float approach =
        glm::dot(xyz(row.velocity) + glm::cross(xyz(row.angularVelocity), arm) - glm::normalize(way) * speed, normal);
    if (approach <= kMinImpactSpeed) return 0.0;
    if (row.products.w >= 0.0f) return std::max(row.products.w, speed / source.from.w) * row.velocity.w;
    const glm::vec3 turn = glm::cross(arm, normal), p = xyz(row.products);
    const glm::vec3 answer =
        xyz(row.inertia) * turn +
        glm::vec3(p.x * turn.y + p.y * turn.z, p.x * turn.x + p.z * turn.z, p.y * turn.x + p.z * turn.y);
    const float thrownBack = approach > kMinRestitutionSpeed ? row.angularVelocity.w : 1.0f;
    return thrownBack * approach / (source.from.w + row.centre.w + glm::dot(turn, answer)) * row.velocity.w;
}

/// A block that flies and rotates near the scene's origin.
Project thrownBlock(DamageRule rule) {
    Project project = test::floatingBlock();
    project.instances[0].pose.position = kOrigin + Vec3(0.0, 2.0, 0.0);
    project.gravity = {0.0, -9.81, 0.0};
    project.damage.rule = rule;
    return project;
}

}  // namespace

class SurfaceHeatTest : public QObject {
    Q_OBJECT
private slots:
    void rowsEvaluateToTheForecast_data() {
        QTest::addColumn<int>("rule");
        QTest::newRow("impact") << static_cast<int>(DamageRule::Impact);
        QTest::newRow("momentum") << static_cast<int>(DamageRule::Momentum);
    }
    void rowsEvaluateToTheForecast() {
        QFETCH(int, rule);
        Session session = test::sessionOf(thrownBlock(static_cast<DamageRule>(rule)));
        const Hammer hammer{.at = kOrigin + Vec3(0.4, 2.3, 0.25), .impulse = {0.0, 30.0, -60.0}};
        test::addInput(session, ShotInput{"hammer", hammer});
        for (int k = 0; k < 20; ++k) session.step();  // it rotates about all its axes
        const Throw thrown{
            .size = Vec3(0.2), .mass = 7.0, .from = kOrigin + Vec3(1.0, 3.0, 5.0), .to = kOrigin, .speed = 20.0};
        const BodyForecast forecast = breakForecast(session, thrown).value().at(1);
        QVERIFY(std::isfinite(forecast.threshold));
        const SurfaceHeat row = surfaceHeat(forecast, kOrigin);
        const HeatSource source = heatSource(forecast.projectile, kOrigin);
        Random random(91);
        int hot = 0;
        for (int k = 0; k < 1000; ++k) {
            const auto any = [&] {
                return Vec3(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0));
            };
            const Vec3 point = forecast.mass.centre + any(), normal = glm::normalize(any());
            const double expected = forecast.at(point, normal);
            const double told = heatOf(row, source, glm::vec3(point - kOrigin), glm::vec3(normal));
            QVERIFY2(std::abs(told - expected) <= 1e-4 * std::max(1.0, expected), qPrintable(QString::number(k)));
            hot += expected > 0.0 ? 1 : 0;
        }
        QVERIFY(hot > 200);
    }
    void onlyBreakableBodiesHaveRows() {
        const auto scene = test::playSceneOf(test::floatingBlock());
        Session session = Session::start(scene).value();
        SessionSceneBuilder builder(scene);
        builder.setOverlays({.hasHeat = true});
        const auto forecast = [&] { return breakForecast(session, test::throwAtBlock(2.0, 8.0)).value(); };
        builder.setForecast(forecast());
        const auto aimed = builder.sceneOf(session);
        QCOMPARE(aimed->heats.size(), std::size_t{1});
        QCOMPARE(std::ranges::count(aimed->appearances, 1u, &BodyAppearance::heat), 1);
        test::addInput(session, BreakInput{1});
        session.step();
        builder.setForecast(forecast());
        QVERIFY(builder.sceneOf(session)->heats.empty());  // pieces do not break again
    }
    void noRowsWithoutForecast() {
        const auto scene = test::playSceneOf(test::floatingBlock());
        Session session = Session::start(scene).value();
        SessionSceneBuilder builder(scene);
        builder.setOverlays({.hasHeat = true});
        for (int k = 0; k < 5; ++k) {  // scenes are recycled
            const bool isAimed = k % 2 == 0;
            builder.setForecast(std::nullopt);
            if (isAimed) builder.setForecast(breakForecast(session, test::throwAtBlock(2.0, 8.0)).value());
            const auto moment = builder.sceneOf(session);
            QCOMPARE(moment->heats.size(), std::size_t{isAimed});
            QCOMPARE(std::ranges::count(moment->appearances, 0u, &BodyAppearance::heat) + (isAimed ? 1 : 0),
                     static_cast<std::ptrdiff_t>(moment->appearances.size()));
            session.step();
        }
    }
};

RUBBLE_TEST(SurfaceHeatTest)
#include "SurfaceHeatTest.moc"
