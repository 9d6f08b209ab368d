#include "core/play/breaking/ApplyDamage.h"

#include "core/play/damage/DamageBytes.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"
#include "tests/support/play/Damages.h"

#include <map>
#include <set>

using namespace rubble;

namespace {

constexpr std::uint64_t kApplySeed = 7;

/// What a body is, and where.
using Solid = std::tuple<std::uint32_t, std::uint32_t, PlayRole, std::string>;

std::set<Solid> solidsOf(const Session& session) {
    std::set<Solid> solids;
    for (const PlayBody& body : session.bodies()) {
        const Pose pose = session.world().state(body.body).pose;
        const std::string place(reinterpret_cast<const char*>(&pose), sizeof(pose));
        solids.emplace(body.origin, body.fragment, body.role, place);
    }
    return solids;
}

std::string refusalOf(const Status& status) { return status ? std::string() : status.error().message; }

}  // namespace

class ApplyDamageTest : public QObject {
    Q_OBJECT
private slots:
    void aFreshSessionGetsTheSameBodiesAtTheirRestPoses() {
        const auto scene = test::playSceneOf(test::threeBlocks());
        Session session = *Session::start(scene);
        QVERIFY(session.damage().at(scene->project.instances[0].id).isIntact());
        test::addInput(session, BreakInput{1});
        session.step();
        test::addInput(session, BreakInput{4});
        for (int k = 0; k < 30; ++k) session.step();

        Session fresh = test::damaged(scene, session.damage());
        QVERIFY(fresh.damage() == session.damage());
        QVERIFY(fresh.events().born.empty() && fresh.events().breaks.empty());
        QCOMPARE(fresh.stepsDone(), std::uint64_t{0});
        QCOMPARE(fresh.bodies().size(), session.bodies().size());
        for (std::size_t k = 0; k < fresh.bodies().size(); ++k) {
            QCOMPARE(fresh.bodies()[k].number, session.bodies()[k].number);
            QCOMPARE(fresh.bodies()[k].fragment, session.bodies()[k].fragment);
        }
        QVERIFY(test::damaged(scene, session.damage()).hash() == fresh.hash());
        const Vec3 offset = fresh.bodies().back().asset->fragments[fresh.bodies().back().fragment].offset;
        const Vec3 position = fresh.world().state(fresh.bodies().back().body).pose.position;
        QVERIFY(glm::distance(position, offset + Vec3(0.0, 0.5, 0.0)) < 1e-5);
    }
    /// Fragments cut at the point of impact are the same as those of the session that was hit.
    void cutsAreMadeAgain() {
        const Project project = test::threeBlocks();
        const auto scene = test::playSceneOf(project);
        Session session = *Session::start(scene);
        const Throw thrown{
            .size = {0.2, 0.2, 0.2}, .mass = 20, .from = {4.2, 0.6, 1}, .to = {4.2, 0.6, 0}, .speed = 20};
        test::addInput(session, ShotInput{"throw", thrown});
        const std::vector<PlayBreak> breaks = test::breaksWithin(session, 30);
        QVERIFY(!breaks.empty());
        const InstanceDamage damage = session.damage().at(project.instances[2].id);
        QVERIFY(damage.cut.has_value());
        const Session fresh = test::damaged(scene, session.damage());
        const auto isCut = [](const PlayBody& body) { return body.origin == 3; };
        const auto body = std::ranges::find_if(fresh.bodies(), isCut);
        QVERIFY(body != fresh.bodies().end());
        QCOMPARE(body->asset->bake->fractures[0].seeds.positions, breaks[0].asset->bake->fractures[0].seeds.positions);
    }
    /// The whole broke into the fragments of its pattern, since it could not be cut where it was hit.
    void wholesThatWereNotCutAreNotCutLater() {
        const Project project = test::threeBlocks();
        const auto scene = test::playSceneOf(project);
        const Id instance = project.instances[2].id;
        SessionDamage damage{{instance, Session::start(scene)->damage().at(instance)}};
        damage[instance].broken[0] = true;
        const Session session = test::damaged(scene, damage);
        QCOMPARE(test::countOf(session, PlayRole::Debris), 5u);
        QVERIFY(session.damage().at(instance) == damage[instance]);
    }
    void damagedBondsAreAppliedWhereNoneIsBroken() {
        const Project project = test::bondedWall(30);
        const auto scene = test::playSceneOf(project);
        SessionDamage damage = Session::start(scene)->damage();
        damage.begin()->second.partial[7] = 100;
        QVERIFY(test::damaged(scene, damage).damage() == damage);
    }
    /// Two walls of one asset.
    void otherInstancesStayIntact() {
        Project project = test::bondedWall(30);
        test::addInstance(project, project.assets[0].id, "other", {.position = {10.0, 1.5, 0.0}});
        const auto scene = test::playSceneOf(project);
        const Id first = project.instances[0].id, second = project.instances[1].id;
        SessionDamage damage = Session::start(scene)->damage();
        damage[second].broken[0] = true;
        const Session session = test::damaged(scene, {{second, damage[second]}});
        QVERIFY(session.damage().at(first).isIntact());
        QVERIFY(session.damage() == damage);
    }
    /// Bodies that came off a moment ago hold their deeper levels, but not those of a damage.
    void damagedBodiesBreakAtTheirNextLevelAtOnce() {
        const auto scene = test::playSceneOf(test::clusteredWall(60, 4));
        Session session = *Session::start(scene, {.dt = 1.0 / 240.0});
        test::addInput(session, BreakInput{1});
        session.step();
        for (const bool isApplied : {false, true}) {
            if (isApplied) QVERIFY(session.apply(session.damage()).hasValue());
            const std::size_t before = session.bodies().size();
            test::addInput(session, BreakInput{1});
            session.step();
            QCOMPARE(session.bodies().size() > before, isApplied);
        }
    }
    void mergedDamageIsThatOfBothOneAfterTheOther() {
        qInfo("seed %d", static_cast<int>(kApplySeed));
        Random random(kApplySeed);
        const auto scene = test::playSceneOf(test::threeBlocks());
        int compared = 0;
        for (int round = 0; round < 60; ++round) {
            const SessionDamage a = test::randomDamage(scene, random), b = test::randomDamage(scene, random);
            SessionDamage merged;
            for (const auto& [id, one] : a) merged[id] = *mergedDamage(one, b.at(id));
            Session together = test::damaged(scene, merged), after = test::damaged(scene, a);
            QVERIFY(together.damage() == merged);
            if (const Status applied = after.apply(b); !applied) {
                QVERIFY(applied.error().message.find("cut at another point") != std::string::npos);
                continue;
            }
            ++compared;
            QVERIFY(after.damage() == merged);
            QVERIFY(solidsOf(after) == solidsOf(together));
            QVERIFY(after.apply(a).hasValue());
            QVERIFY(solidsOf(after) == solidsOf(together));
            for (int k = 0; k < 10; ++k) together.step();  // contacts between the fragments are sound
        }
        QVERIFY(compared > 30);
    }
    /// Each message has the whole damage, since some are lost and the joiner missed what was before.
    void aLateJoinerEndsWithTheSameDamage() {
        qInfo("seed %d", static_cast<int>(kApplySeed));
        Random random(kApplySeed);
        const auto scene = test::playSceneOf(test::threeBlocks());
        Session host = *Session::start(scene), joiner = *Session::start(scene);
        SessionDamage before = host.damage();
        for (int step = 0; step < 240; ++step) {
            if (step % 20 == 0) test::breakAtRandom(host, 1, random);
            host.step();
            const bool isLate = step < 60, isLost = random.below(20) == 0 && step != 239;
            const SessionDamage now = host.damage();
            for (const auto& [id, damage] : now) {
                const std::string whole = damageBytes(damage);
                if (!isLate && !isLost) QVERIFY(joiner.apply({{id, *damageOfBytes(whole)}}).hasValue());
                if (!isLate)
                    QVERIFY(joiner.apply({{id, *damageSince(damage, before.at(id))}}).hasValue() || step == 60);
            }
            joiner.step();
            before = now;
        }
        QVERIFY(joiner.damage() == host.damage());
        QVERIFY(!joiner.damage().begin()->second.isIntact());
    }
    void whatCannotBeAppliedIsRefusedWithTheInstance() {
        Project project = test::threeBlocks();
        project.instances[1].isUnbreakable = true;
        const auto scene = test::playSceneOf(project);
        Session session = *Session::start(scene);
        const Id first = project.instances[0].id, second = project.instances[1].id, cut = project.instances[2].id;
        SessionDamage damage = session.damage();
        QVERIFY(session.apply(damage).hasValue());
        damage[second].broken[0] = true;
        QCOMPARE(refusalOf(session.apply(damage)),
                 std::string("Instance \"second\": it is unbreakable, so no damage can be applied to it."));
        QVERIFY(refusalOf(session.apply({{99, damage[first]}})).starts_with("There is no instance 99"));
        QVERIFY(refusalOf(session.apply({{cut, damage[first]}})).starts_with("Instance \"cut\": The damage is of the"));
        InstanceDamage wrong = damage[first];
        wrong.cut = ImpactCut{{0.0, 0.0}, 1};
        wrong.broken[0] = true;
        QCOMPARE(refusalOf(session.apply({{first, wrong}})),
                 std::string("Instance \"block\": The asset is not cut at the point of impact."));
        QVERIFY(session.hash() == Session::start(scene)->hash());
    }
};

RUBBLE_TEST(ApplyDamageTest)
#include "ApplyDamageTest.moc"
