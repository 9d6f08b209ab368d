#include "core/play/session/SessionRemap.h"

#include "tests/support/TestProgram.h"
#include "tests/support/play/Damages.h"

using namespace rubble;

namespace {

/// A session of three blocks, of which the first two broke.
Session broken(const Project& project) {
    Session session = test::sessionOf(project);
    for (const std::uint32_t number : {1u, 2u}) test::addInput(session, BreakInput{number});
    session.step();
    return session;
}

}  // namespace

class SessionRemapTest : public QObject {
    Q_OBJECT
private slots:
    void sameSceneKeepsAllDamage() {
        const Project project = test::threeBlocks();
        const Session session = broken(project);
        const Result<RemappedSession> same = remappedSession(session, *test::playSceneOf(project));
        QVERIFY(same && same->losses.empty() && same->damage.size() == 2);
        Session other = test::sessionOf(project);
        QVERIFY(other.apply(same->damage));
        QVERIFY(other.damage() == session.damage());
    }
    /// The first block breaks into the fragments of the new bake; what does not exist any more is reported.
    void changedSeedsKeepWhatTheyCan() {
        Project project = test::threeBlocks();
        Session session = broken(project);
        const PlayBody& fragment = *std::ranges::find_if(session.bodies(), [&](const PlayBody& body) {
            return body.fragment != kNone && body.fracture() != nullptr &&
                   body.asset->bake->fragmentPath(body.fragment) ==
                       session.scene().assets.begin()->second->bake->fragmentPath(4);
        });
        test::addInput(session, BreakInput{fragment.number});
        session.step();
        std::get<UniformScatter>(project.assets[0].pattern.layers[0].parameters).count = 4u;
        const auto scene = test::playSceneOf(project);
        const Result<RemappedSession> mapped = remappedSession(session, *scene);
        QVERIFY(mapped.hasValue());
        QCOMPARE(mapped->losses.size(), std::size_t{1});
        QVERIFY2(
            mapped->losses[0].ends_with(": 1 broken fragment does not exist or break in this bake and is dropped."),
            mapped->losses[0].c_str());
        Session other = *Session::start(scene);
        QVERIFY(other.apply(mapped->damage));
        for (const auto& [id, damage] : mapped->damage) QVERIFY(other.damage().at(id) == damage);
    }
    void missingAndUnbreakableInstancesLoseTheirDamage() {
        Project project = test::threeBlocks();
        const Session session = broken(project);
        const std::string first = project.instances[0].name, second = project.instances[1].name;
        project.instances[1].isUnbreakable = true;
        project.instances.erase(project.instances.begin());
        const Result<RemappedSession> mapped = remappedSession(session, *test::playSceneOf(project));
        QVERIFY(mapped && mapped->damage.empty());
        QCOMPARE(mapped->losses.at(0), "Instance \"" + first + "\" is gone; its damage is dropped.");
        QCOMPARE(mapped->losses.at(1), "Instance \"" + second + "\" is unbreakable now; its damage is dropped.");
    }
};

RUBBLE_TEST(SessionRemapTest)
#include "SessionRemapTest.moc"
