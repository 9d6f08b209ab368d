#include "core/play/scene/LiveInputs.h"

#include "core/asset/strength/Threshold.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"

using namespace rubble;

namespace {

/// What takes a block to a state in which something is changed.
template <class Change>
std::optional<std::vector<PlayInput>> after(const Change& change) {
    const Project played = test::floatingBlock();
    Project now = played;
    change(now);
    return liveInputs(played, now);
}

using Inputs = std::vector<PlayInput>;

}  // namespace

class LiveInputsTest : public QObject {
    Q_OBJECT
private slots:
    void numbersChangeLive() {
        const Project block = test::floatingBlock();
        const Id asset = block.assets[0].id, instance = block.instances[0].id;
        QCOMPARE(after([](Project& now) { now.assets[0].threshold = 7.0; }),
                 (Inputs{ThresholdInput{.asset = asset, .threshold = 7.0}}));
        QCOMPARE(after([](Project& now) { now.instances[0].threshold = 8.0; }),
                 (Inputs{ThresholdInput{.instance = instance, .threshold = 8.0}}));
        QCOMPARE(after([](Project& now) { now.gravity = Vec3(1.0, 2.0, 3.0); }),
                 (Inputs{GravityInput{Vec3(1.0, 2.0, 3.0)}}));
        Material heavy = block.materials[0];
        heavy.density = 5000.0;
        QCOMPARE(after([&](Project& now) { now.materials[0] = heavy; }), (Inputs{MaterialInput{heavy}}));
    }
    void derivedThresholdsChangeLive() {
        Project played = test::floatingBlock();
        played.materials[0].tensileStrength = 1e6;
        deriveThreshold(played.assets[0]);
        const Id asset = played.assets[0].id;
        Project now = played;
        now.materials[0].tensileStrength = 3e6;
        const auto derived = [&] {
            return ThresholdInput{.asset = asset, .threshold = thresholdOf(now, now.assets[0])};
        };
        QCOMPARE(liveInputs(played, now), (Inputs{derived()}));
        now.materials[0].youngsModulus = 1e9;
        QCOMPARE(liveInputs(played, now), (Inputs{derived()}));
        enterThreshold(now.assets[0], 7.0);
        QCOMPARE(liveInputs(played, now), (Inputs{ThresholdInput{.asset = asset, .threshold = 7.0}}));
        now = played;
        now.assets[0].threshold = 7.0;  // not in force
        now.materials[0].fractureToughness = 1e6;
        QCOMPARE(liveInputs(played, now), Inputs{});
    }
    void severalChangesAtOnce() {
        const auto inputs = after([](Project& now) {
            now.assets[0].threshold = 7.0;
            now.materials[0].friction = 0.1;
            now.materials[0].restitution = 0.5;
        });
        QVERIFY(inputs && inputs->size() == 2);
    }
    void irrelevantChangesGiveNoInputs() {
        QCOMPARE(after([](Project&) {}), Inputs{});
        QCOMPARE(after([](Project& now) {
                     now.materials[0].name = now.assets[0].name = now.instances[0].name = "another";
                     now.assets[0].requirements.push_back({});
                     now.shots.push_back({.id = now.nextId++, .name = "shot"});
                 }),
                 Inputs{});
    }
    void otherChangesNeedARestart() {
        QVERIFY(!after([](Project& now) { now.assets[0].prism().depth = 0.4; }));
        QVERIFY(!after([](Project& now) { now.assets[0].pattern.layers.clear(); }));
        QVERIFY(!after([](Project& now) { now.instances[0].pose.position.x = 1.0; }));
        QVERIFY(!after([](Project& now) { now.instances.clear(); }));
        QVERIFY(!after([](Project& now) { now.instances[0].isFixed = true; }));
        QVERIFY(!after([](Project& now) { now.materials[0].outside.red = 0.1; }));
        QVERIFY(!after([](Project& now) { now.ground.height = -1.0; }));
        QVERIFY(!after([](Project& now) { now.damage.isThesis = true; }));
        QVERIFY(!after([](Project& now) { now.debris.lifetime = 3.0; }));
        QVERIFY(!after([](Project& now) { now.events.maxRecords = 3; }));
    }
    void everyChangeOfBondsNeedsARestart() {
        QVERIFY(!after([](Project& now) { now.assets[0].breakAs = BreakAs::Bonded; }));
        QVERIFY(!after([](Project& now) { now.assets[0].levels.push_back({.bondStrength = 2.0}); }));
        QVERIFY(!after([](Project& now) { now.instances[0].isAnchored = true; }));
        QVERIFY(!after([](Project& now) { now.instances[0].bondStrength = 2.0; }));
        QVERIFY(!after([](Project& now) { now.mortars.push_back({.id = now.nextId++, .name = "joints"}); }));
        const auto afterBonds = [](const auto& change) {
            return after([&](Project& now) { change(now.assets[0].bonding); });
        };
        QVERIFY(!afterBonds([](Bonding& bonding) { bonding.impulsePerArea = 7.0; }));
        QVERIFY(!afterBonds([](Bonding& bonding) { bonding.radius = 0.1; }));
        QVERIFY(!afterBonds([](Bonding& bonding) { bonding.falloff = HitFalloff::Smooth; }));
        QVERIFY(!afterBonds([](Bonding& bonding) { bonding.damageFrom = 1.0; }));
        QVERIFY(!afterBonds([](Bonding& bonding) { bonding.span = 1.0; }));
        QVERIFY(!afterBonds([](Bonding& bonding) { bonding.collapseDelay = 1.0; }));
        QVERIFY(!afterBonds([](Bonding& bonding) { bonding.minimumIsland = 2; }));
        QVERIFY(!afterBonds([](Bonding& bonding) { bonding.strokes.push_back({.points = {{0.0, 0.0}}}); }));
        QVERIFY(!afterBonds([](Bonding& bonding) { bonding.heightStrengths.push_back({.height = 1.0}); }));
        QVERIFY(!afterBonds([](Bonding& bonding) { bonding.strengthImage.emplace(); }));
        QVERIFY(!afterBonds([](Bonding& bonding) { bonding.neverBreaks = {"3.1"}; }));
        QVERIFY(!afterBonds([](Bonding& bonding) { bonding.clusters = {{0, {"3.1", "3.2"}}}; }));
    }
    void clearingAnInstancesThresholdNeedsARestart() {
        Project played = test::floatingBlock();
        Project now = played;
        played.instances[0].threshold = 50.0;
        QVERIFY(!liveInputs(played, now));
    }
    void liveInputsMatchAProjectThatHadThemFromTheStart() {
        Project now = test::floatingBlock();
        now.assets[0].threshold = 1e6;
        Session live = test::sessionOf(test::floatingBlock()), anew = test::sessionOf(now);
        const auto inputs = liveInputs(test::floatingBlock(), now);
        for (const PlayInput& input : *inputs) test::addInput(live, input);
        for (Session* session : {&live, &anew})
            test::addInput(*session, ShotInput{"throw", test::throwAtBlock(3.0, 60.0)});
        QCOMPARE(test::breaksWithin(live, 30).size(), 0u);
        QCOMPARE(test::breaksWithin(anew, 30).size(), 0u);
        QCOMPARE(live.hash(), anew.hash());
    }
};

RUBBLE_TEST_WITH(LiveInputsTest, QCoreApplication)
#include "LiveInputsTest.moc"
