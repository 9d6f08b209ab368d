#include "tests/support/TestProgram.h"
#include "tests/support/asset/RockFace.h"
#include "tests/support/play/Sessions.h"

#include <QTest>

using namespace rubble;

/// The demo rock face, in clusters.
class RockFaceTest : public QObject {
    Q_OBJECT
private slots:
    void standsForAMinute() {
        Session session = test::sessionOf(test::rockFace());
        for (int k = 0; k < 3600; ++k) session.step();
        QCOMPARE(session.bodies().size(), std::size_t{2});
        QVERIFY(session.damage().begin()->second.isIntact());
    }
    /// A large part comes off first, and breaks up later.
    void comesOffInLargeParts() {
        Session session = test::sessionOf(test::rockFace());
        QVERIFY(session.add(session.scene().project.shots[0]).hasValue());
        std::size_t largest = 0, free = 0;  // fragments of the first that came off, and bodies in the end
        for (int k = 0; k < 360; ++k) {
            session.step();
            for (const PlayBody& body : session.bodies()) {
                if (largest == 0 && body.asset != nullptr && !body.isHeld && k > 0 && !body.nodes.empty())
                    largest = std::max(largest, body.nodes.size());
            }
        }
        for (const PlayBody& body : session.bodies()) free += body.asset != nullptr && !body.isHeld ? 1 : 0;
        qInfo("the first part has %zu fragments; %zu bodies came off in the end", largest, free);
        QVERIFY(largest >= 20 && free >= 4);
    }
};

RUBBLE_TEST(RockFaceTest)
#include "RockFaceTest.moc"
