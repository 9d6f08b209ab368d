#include "core/play/session/PlayTestRun.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/TwoStoreyHouse.h"
#include "tests/support/play/Sessions.h"

#include <QTest>

using namespace rubble;

namespace {

/// The number of fragments that are held.
std::size_t heldFragments(const Session& session) {
    std::size_t count = 0;
    for (const PlayBody& body : session.bodies()) count += body.isHeld ? bondedFragments(body).size() : 0;
    return count;
}

Session houseAfter(std::size_t shot) {
    Session session = test::sessionOf(test::twoStoreyHouse());
    const Shot& one = session.scene().project.shots[shot];
    test::addInput(session, ShotInput{one.name, one.action});
    for (int k = 0; k < 300; ++k) session.step();
    return session;
}

}  // namespace

/// The demo house of two storeys.
class TwoStoreyHouseTest : public QObject {
    Q_OBJECT
private slots:
    void passesItsTests() {
        const auto scene = test::playSceneOf(test::twoStoreyHouse());
        QCOMPARE(scene->project.playTests.size(), std::size_t{6});
        for (const PlayTest& test : scene->project.playTests) {
            const Result<PlayTestOutcome> outcome = runPlayTest(scene, test);
            QVERIFY(outcome.hasValue());
            for (const ExpectationOutcome& one : outcome->expectations)
                QVERIFY2(one.isMet, (test.name + ": " + one.expected + ": " + one.seen).c_str());
        }
    }
    void isOneStructure() {
        const auto scene = test::playSceneOf(test::twoStoreyHouse());
        QCOMPARE(scene->structures.size(), scene->project.instances.size());
        for (const auto& [instance, structure] : scene->structures) {
            QVERIFY(structure->isHeld());
            QVERIFY(!structure->mortar.empty());
        }
    }
    /// No part is farther from its supports than its span: a scratch brings nothing down.
    void aBlowThatBreaksOneBondLeavesAllElse() {
        const Project project = test::twoStoreyHouse();
        Session session = test::sessionOf(project);
        const std::size_t before = heldFragments(session);
        for (const PlayBody& body : std::vector(session.bodies())) {
            if (body.role != PlayRole::Instance) continue;
            const Vec3 at = session.world().state(body.body).centre;
            test::addInput(session, ShotInput{"tap", Blast{.at = at, .impulse = 2000.0, .radius = 0.3}});
        }
        for (int k = 0; k < 120; ++k) session.step();
        const std::size_t lost = before - heldFragments(session);
        QVERIFY2(lost < 30, QByteArray::number(static_cast<int>(lost)));
    }
    void whatStandsAfterTheBlastGoesOnStanding() {
        Session session = houseAfter(3);
        const std::size_t held = heldFragments(session);
        qInfo("%zu fragments stand", held);
        QVERIFY(held > 1000 && held < 1900);
        const SessionDamage damage = session.damage();
        for (int k = 0; k < 3000; ++k) session.step();
        QVERIFY(session.damage() == damage);
        QCOMPARE(heldFragments(session), held);
    }
};

RUBBLE_TEST(TwoStoreyHouseTest)
#include "TwoStoreyHouseTest.moc"
