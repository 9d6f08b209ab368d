#include "core/play/breaking/BondBreaking.h"

#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"

#include <algorithm>

using namespace rubble;

namespace {

Session thrownAtWall(const Project& project, const Throw& thrown, int steps, const SessionSettings& settings = {}) {
    Session session = test::sessionOf(project, settings);
    test::addInput(session, ShotInput{"ball", thrown});
    for (int k = 0; k < steps; ++k) session.step();
    return session;
}

}  // namespace

class BondBreakingTest : public QObject {
    Q_OBJECT
private slots:
    void ballMakesAHole() {
        const Session session = thrownAtWall(test::bondedWall(), test::ballAtWall(), 300);
        const PlayBody& wall = test::wallOf(session);
        QCOMPARE(wall.role, PlayRole::Instance);
        QVERIFY(wall.isHeld);
        QVERIFY(session.world().kind(wall.body) == BodyKind::Static);
        QVERIFY2(wall.nodes.size() > 240 && wall.nodes.size() < 296, qPrintable(QString::number(wall.nodes.size())));
        QVERIFY(session.world().state(wall.body).pose.position == Vec3(0.0, 1.5, 0.0));
        const PlayBody* ball = nullptr;
        for (const PlayBody& body : session.bodies()) ball = body.role == PlayRole::Projectile ? &body : ball;
        QVERIFY(ball != nullptr);
        QVERIFY2(session.world().state(ball->body).centre.z < -0.3,
                 qPrintable(QString::number(session.world().state(ball->body).centre.z)));
        qInfo("%zu nodes left, %zu bodies", wall.nodes.size(), session.bodies().size());
    }
};

RUBBLE_TEST(BondBreakingTest)
#include "BondBreakingTest.moc"
