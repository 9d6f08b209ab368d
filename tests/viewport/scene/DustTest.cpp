#include "tests/support/TestProgram.h"
#include "viewport/scene/Dust.h"

#include "tests/support/editor/Sessions.h"

using namespace rubble;
using test::addInput;
using test::floatingBlock;

namespace {

/// The puffs of a session's scene.
std::vector<DustPuff> puffsOf(const Session& session) {
    RenderScene scene;
    addDust(scene, session);
    return scene.puffs;
}

/// A block that broke one step ago.
Session brokenBlock() {
    Session session = test::sessionOf(floatingBlock(5));
    addInput(session, BreakInput{1});
    session.step();
    return session;
}

void step(Session& session, int steps) {
    for (int k = 0; k < steps; ++k) session.step();
}

bool areSame(const DustPuff& a, const DustPuff& b) {
    return a.position == b.position && a.previousOffset == b.previousOffset && a.colour == b.colour;
}

}  // namespace

class DustTest : public QObject {
    Q_OBJECT
private slots:
    void breakEmitsDustAtItsCuts() {
        Session whole = test::sessionOf(floatingBlock(5));
        step(whole, 1);
        QVERIFY(puffsOf(whole).empty());
        const std::vector<DustPuff> puffs = puffsOf(brokenBlock());
        QVERIFY(puffs.size() >= 10);
        for (const DustPuff& puff : puffs) {
            const glm::vec3 arm = glm::vec3(puff.position) - glm::vec3(0.0f, 5.0f, 0.0f);
            QVERIFY(std::abs(arm.x) < 0.55f && std::abs(arm.y) < 0.55f && std::abs(arm.z) < 0.3f);
            QVERIFY(puff.previousOffset.w > 0.05f && puff.position.w > 0.02f);
        }
    }
    void dustDriftsGrowsAndFades() {
        Session session = brokenBlock();
        step(session, 5);
        const std::vector<DustPuff> early = puffsOf(session);
        step(session, 20);
        const std::vector<DustPuff> late = puffsOf(session);
        QVERIFY(late.size() == early.size());
        for (std::size_t k = 0; k < late.size(); ++k) {
            QVERIFY(late[k].position.w > early[k].position.w && late[k].previousOffset.w < early[k].previousOffset.w);
            QVERIFY(glm::distance(late[k].position, early[k].position) > 0.05f);
        }
        step(session, 35);
        QVERIFY(puffsOf(session).empty());
        QVERIFY(session.recentBreaks().empty());
    }
    void dustIsDeterministicAfterSeeking() {
        Session session = brokenBlock(), other = brokenBlock();
        step(session, 10);
        const auto then = session.snapshot();
        const std::vector<DustPuff> puffs = puffsOf(session);
        step(other, 10);
        QVERIFY(std::ranges::equal(puffs, puffsOf(other), areSame));
        step(session, 60);
        session.restore(*then);
        QVERIFY(std::ranges::equal(puffs, puffsOf(session), areSame));
    }
    void previousOffsetMatchesThePreviousScene() {
        Session session = brokenBlock();
        const std::vector<DustPuff> before = puffsOf(session);
        step(session, 1);
        const std::vector<DustPuff> now = puffsOf(session);
        for (std::size_t k = 0; k < now.size(); ++k) {
            QVERIFY(glm::distance(glm::vec3(now[k].position + now[k].previousOffset), glm::vec3(before[k].position)) <
                    1e-5f);
        }
    }
};

RUBBLE_TEST_WITH(DustTest, QCoreApplication)
#include "DustTest.moc"
