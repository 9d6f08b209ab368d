#include "tests/support/TestProgram.h"
#include "viewport/scene/Dust.h"

#include "tests/support/play/Sessions.h"

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

/// The same of another material.
Session brokenBlockOf(const Material& like, const Vec3& gravity = Vec3(0.0)) {
    Project project = floatingBlock(5);
    project.gravity = gravity;
    Material& material = project.materials[0];
    material.outside = like.outside;
    material.inside = like.inside;
    material.opacity = like.opacity;
    material.fractureToughness = like.fractureToughness;
    Session session = test::sessionOf(project);
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
        step(session, 10);
        const std::vector<DustPuff> late = puffsOf(session);
        QVERIFY(late.size() == early.size());
        for (std::size_t k = 0; k < late.size(); ++k) {
            QVERIFY(late[k].position.w > early[k].position.w && late[k].previousOffset.w < early[k].previousOffset.w);
            QVERIFY(glm::distance(late[k].position, early[k].position) > 0.05f);
        }
        step(session, 45);
        QVERIFY(puffsOf(session).empty());
        QVERIFY(session.recentBreaks().empty());
    }
    void brickMakesShortLivedDustOfItsColour() {
        const Colour clay{0.55, 0.30, 0.20};
        Session session = brokenBlockOf({.outside = clay, .inside = clay});
        step(session, 2);
        const std::vector<DustPuff> puffs = puffsOf(session);
        QVERIFY(puffs.size() >= 10);
        for (const DustPuff& puff : puffs) {
            QVERIFY(!puff.isSplinter());
            QVERIFY(puff.colour.x > puff.colour.y + 0.1f && puff.colour.y > puff.colour.z);
        }
        step(session, 40);  // 0.7 s
        QVERIFY(puffsOf(session).empty());
    }
    void glassSplintersAndMakesHardlyAnyDust() {
        Session session = brokenBlockOf({.opacity = 0.3}, {0.0, -9.81, 0.0});
        step(session, 2);
        const std::vector<DustPuff> early = puffsOf(session);
        const auto splinters = std::ranges::count_if(early, &DustPuff::isSplinter);
        QVERIFY(splinters >= 50 && std::ssize(early) - splinters <= 4);
        for (const DustPuff& puff : early) {
            QVERIFY(puff.isSplinter() ? puff.position.w < 0.021f : puff.previousOffset.w < 0.15f);
            QVERIFY(puff.colour.w < 2.0f);
        }
        step(session, 20);
        const std::vector<DustPuff> late = puffsOf(session);
        QVERIFY(!late.empty() && std::ranges::all_of(late, &DustPuff::isSplinter));
        const auto height = [](const std::vector<DustPuff>& puffs) {
            float sum = 0.0f;
            for (const DustPuff& puff : puffs) sum += puff.position.y;
            return sum / static_cast<float>(puffs.size());
        };
        QVERIFY(height(late) < height(early) - 0.2f);  // they fall
        QVERIFY(!std::ranges::equal(
            early, late, {}, [](const DustPuff& puff) { return puff.colour.w; },
            [](const DustPuff& puff) { return puff.colour.w; }));  // and rotate
        step(session, 35);                                         // 0.95 s
        QVERIFY(puffsOf(session).empty());
    }
    void toughMaterialsMakeHardlyAnyDust() {
        Session session = brokenBlockOf({.fractureToughness = 5e7});
        step(session, 2);
        QVERIFY(puffsOf(session).size() <= 4);
    }
    /// A pane of 8 m makes no clouds that hide it.
    void cloudsOfLargeBodiesAreSmall() {
        Project project = floatingBlock(5);
        for (Vec2& point : project.assets[0].prism.outline.outer) point *= 8.0;
        Session session = test::sessionOf(project);
        addInput(session, BreakInput{1});
        step(session, 20);
        for (const DustPuff& puff : puffsOf(session)) QVERIFY(puff.position.w < 0.6f);
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
