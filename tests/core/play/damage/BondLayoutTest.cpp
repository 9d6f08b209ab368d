#include "core/play/damage/BondLayout.h"

#include "core/play/damage/DamageBytes.h"
#include "core/play/session/SessionRemap.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"
#include "tests/support/play/Damages.h"

#include <set>

using namespace rubble;

namespace {

/// A wall with two levels, after some hits.
Project wallOfLevels() {
    Project project = test::bondedWall(60);
    project.assets[0].levels = {{.pattern = test::patternOf(project, {UniformScatter{.count = 4}})}};
    return project;
}

Session hitSession(const std::shared_ptr<const PlayScene>& scene, Random& random) {
    Session session = *Session::start(scene);
    const std::uint64_t shots = 1 + random.below(3);
    for (std::uint64_t k = 0; k < shots; ++k) {
        const Vec2 at{random.between(-1.8, 1.8), random.between(0.3, 2.8)};
        test::addInput(session, ShotInput{"ball", test::ballAtWall(at, random.between(5.0, 200.0), 20.0)});
        for (int step = 0; step < 40; ++step) session.step();
    }
    return session;
}

/// What the bodies are: their fragments, without numbers and poses.
std::multiset<std::vector<std::uint32_t>> fragmentSetsOf(const Session& session) {
    std::multiset<std::vector<std::uint32_t>> solids;
    for (const PlayBody& body : session.bodies()) {
        if (body.asset == nullptr) continue;
        solids.insert(isPartial(body) ? fragmentsOf(body) : std::vector{body.fragment});
    }
    return solids;
}

}  // namespace

class BondLayoutTest : public QObject {
    Q_OBJECT
private slots:
    void wholeComesFirst() {
        const auto scene = test::playSceneOf(wallOfLevels());
        const Instance& instance = scene->project.instances[0];
        const BondLayout layout = bondLayout(*scene, {.instance = instance.id, .asset = instance.asset});
        QVERIFY(layout.structures.size() > 30);
        QCOMPARE(layout.structures[0].get(), scene->structures.begin()->second.get());
        QCOMPARE(layout.structureOf(kNone), 0u);
        QCOMPARE(layout.structureOf(layout.structures[3]->parent), 3u);
        QCOMPARE(layout.firstBond.size(), layout.structures.size() + 1);
        QCOMPARE(layout.firstBond[1], layout.structures[0]->graph.bondCount());
    }
    void aFreshSessionGetsTheSameIslands() {
        constexpr int kSeed = 3;
        qInfo("seed %d", kSeed);
        Random random(kSeed);
        const auto scene = test::playSceneOf(wallOfLevels());
        for (int round = 0; round < 20; ++round) {
            const Session session = hitSession(scene, random);
            const SessionDamage damage = session.damage();
            const Session fresh = test::damaged(scene, damage);
            QVERIFY(fresh.damage() == damage);
            QVERIFY2(fragmentSetsOf(fresh) == fragmentSetsOf(session), QByteArray::number(round));
            const InstanceDamage& one = damage.begin()->second;
            const std::string bytes = damageBytes(one);
            QVERIFY(bytes.size() <= one.broken.size() / 8 + 64 + 4 * one.partial.size());
            QVERIFY(*damageOfBytes(bytes) == one);
        }
    }
    void mergingIsCommutativeAndIdempotent() {
        constexpr int kSeed = 4;
        qInfo("seed %d", kSeed);
        Random random(kSeed);
        const auto scene = test::playSceneOf(wallOfLevels());
        for (int round = 0; round < 10; ++round) {
            const InstanceDamage a = hitSession(scene, random).damage().begin()->second;
            const InstanceDamage b = hitSession(scene, random).damage().begin()->second;
            const InstanceDamage merged = *mergedDamage(a, b);
            QVERIFY(merged == *mergedDamage(b, a));
            QVERIFY(merged == *mergedDamage(merged, a));
            QVERIFY(*mergedDamage(a, *damageSince(merged, a)) == merged);
        }
    }
    void damageOfAnotherKindIsRefused() {
        const auto scene = test::playSceneOf(test::bondedWall(20));
        const Instance& instance = scene->project.instances[0];
        const BondLayout layout = bondLayout(*scene, {.instance = instance.id, .asset = instance.asset});
        const ContentHash bake = damageHash(scene->project.assets[0], *test::onlyAsset(*scene).bake);
        InstanceDamage damage = intactBonds(bake, layout);
        QVERIFY(!bondDamageFault(damage, bake, layout));
        damage.kind = DamageKind::Fractures;
        QCOMPARE(
            *bondDamageFault(damage, bake, layout),
            std::string("One damage is of fractures, the other of bonds; only damage of the same kind can be merged."));
        damage = intactBonds(bake, layout);
        damage.broken.pop_back();
        QVERIFY(bondDamageFault(damage, bake, layout)->starts_with("The damages are of "));
        damage = intactBonds(bake, layout);
        damage.partial[layout.count()] = 3;
        QCOMPARE(*bondDamageFault(damage, bake, layout), std::string("The damage of a bond is wrong."));
    }
    void damageIsMappedByTheFragmentsOfBonds() {
        Random random(5);
        Project project = test::bondedWall(60);
        const Session session = hitSession(test::playSceneOf(project), random);
        QVERIFY(!session.damage().begin()->second.isIntact());
        // A level more changes nothing of the fragments of the whole.
        project.assets[0].levels = {{.pattern = test::patternOf(project, {UniformScatter{.count = 4}})}};
        const auto scene = test::playSceneOf(project);
        const Result<RemappedSession> mapped = remappedSession(session, *scene);
        QVERIFY(mapped.hasValue());
        QVERIFY(mapped->losses.empty());
        const InstanceDamage before = session.damage().begin()->second;
        const InstanceDamage& after = mapped->damage.begin()->second;
        QVERIFY(std::equal(before.broken.begin(), before.broken.end(), after.broken.begin()));
        QVERIFY(before.partial == after.partial);
        project.assets[0].breakAs = BreakAs::Whole;
        QCOMPARE(remappedSession(session, *test::playSceneOf(project))->losses.front(),
                 std::string("Instance \"wall\" breaks whole now; its damage is dropped."));
    }
    void damagedBytesAreRefused() {
        Random random(6);
        const auto scene = test::playSceneOf(test::bondedWall(60));
        const std::string bytes = damageBytes(hitSession(scene, random).damage().begin()->second);
        for (int round = 0; round < 3000; ++round) {
            std::string changed = bytes.substr(0, bytes.size() - 8);
            changed[random.below(changed.size())] = static_cast<char>(random.below(256));
            if (round % 3 == 0) changed.resize(random.below(changed.size() + 1));
            const std::uint64_t sum = contentHash(changed).low;
            for (int k = 0; k < 8; ++k) changed.push_back(static_cast<char>(sum >> (8 * k)));
            const Result<InstanceDamage> read = damageOfBytes(changed);
            if (read) QVERIFY(damageBytes(*read) == changed);
        }
    }
};

RUBBLE_TEST(BondLayoutTest)
#include "BondLayoutTest.moc"
