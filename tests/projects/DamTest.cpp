#include "core/play/session/PlayTestRun.h"
#include "core/structure/capacity/BondCapacities.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Dam.h"
#include "tests/support/play/Sessions.h"

#include <QTest>

using namespace rubble;

namespace {

/// The bodies that the dam consists of.
std::vector<const PlayBody*> damBodies(const Session& session) {
    std::vector<const PlayBody*> bodies;
    const Id dam = session.scene().project.instances[0].id;
    for (const PlayBody& body : session.bodies()) {
        if (session.origins()[body.origin].instance == dam) bodies.push_back(&body);
    }
    return bodies;
}

/// The number of bricks that are held.
std::size_t heldBricks(const Session& session) {
    std::size_t count = 0;
    for (const PlayBody* body : damBodies(session)) count += body->isHeld ? fragmentsOf(*body).size() : 0;
    return count;
}

/// The dam some seconds after one of its shots.
Session damAfter(std::size_t shot, int seconds) {
    Session session = test::sessionOf(test::dam());
    test::addInput(session,
                   ShotInput{session.scene().project.shots[shot].name, session.scene().project.shots[shot].action});
    for (int k = 0; k < 60 * seconds; ++k) session.step();
    return session;
}

}  // namespace

/// The demo dam.
class DamTest : public QObject {
    Q_OBJECT
private slots:
    void passesItsTests() {
        const auto scene = test::playSceneOf(test::dam());
        QCOMPARE(scene->project.playTests.size(), std::size_t{3});
        for (const PlayTest& test : scene->project.playTests) {
            const Result<PlayTestOutcome> outcome = runPlayTest(scene, test);
            QVERIFY(outcome.hasValue());
            for (const ExpectationOutcome& one : outcome->expectations)
                QVERIFY2(one.isMet, (test.name + ": " + one.expected + ": " + one.seen).c_str());
        }
    }
    void onlyTheLowestCourseIsAnchored() {
        const auto scene = test::playSceneOf(test::dam());
        const PlayAsset& asset = *scene->assets.begin()->second;
        const auto anchored = anchoredFragments(scene->project.assets[0], *asset.bake, 0);
        QCOMPARE(asset.fragments.size(), std::size_t{496});
        QCOMPARE(anchored.size(), std::size_t{20});
        for (const std::uint32_t k : anchored) QVERIFY(centreInAsset(asset.fragments[k]).y < 0.25);
    }
    void aBallMakesAHoleAndTheRestStands() {
        Session session = damAfter(0, 4);
        const std::size_t held = heldBricks(session);
        qInfo("%zu bricks stand", held);
        QVERIFY2(held >= 470 && held < 494, QByteArray::number(static_cast<int>(held)));
        const SessionDamage damage = session.damage();
        for (int k = 0; k < 10000; ++k) session.step();
        QVERIFY(session.damage() == damage);
    }
    void aBlockLowAtTheFootMakesALargerHole() {
        const Session ball = damAfter(0, 4), block = damAfter(1, 4);
        QVERIFY(heldBricks(block) < heldBricks(ball));
        QVERIFY(heldBricks(block) > 400);
        qInfo("%zu bricks stand", heldBricks(block));
    }
    /// Also anchored bricks that stand alone.
    void onlyTheDamHasItsName() {
        const Session session = damAfter(2, 5);
        const auto bodies = damBodies(session);
        QVERIFY(std::ranges::count_if(bodies, [](const PlayBody* body) { return body->isHeld; }) > 2);
        QCOMPARE(std::ranges::count_if(bodies, [&](const PlayBody* body) { return session.nameOf(*body) == "dam"; }),
                 std::ptrdiff_t{1});
    }
    void aBlastBringsDownWhatItCarried() {
        Session session = damAfter(2, 5);
        double left = 0.0, right = 0.0, middle = 0.0;  // m: the heights that held bricks reach, by x
        for (const PlayBody* body : damBodies(session)) {
            if (!body->isHeld) continue;
            for (const std::uint32_t k : fragmentsOf(*body)) {
                const Vec3 centre = centreInAsset(body->asset->fragments[k]);
                double& top = std::abs(centre.x) < 1.5 ? middle : centre.x < 0.0 ? left : right;
                top = std::max(top, centre.y);
            }
        }
        qInfo("%zu bricks stand", heldBricks(session));
        QVERIFY2(middle < 2.0, QByteArray::number(middle));
        QVERIFY(left > 3.5 && right > 3.5);
        const SessionDamage damage = session.damage();
        for (int k = 0; k < 10000; ++k) session.step();
        QVERIFY(session.damage() == damage);
    }
};

RUBBLE_TEST(DamTest)
#include "DamTest.moc"
