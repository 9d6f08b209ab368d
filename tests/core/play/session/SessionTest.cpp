// Tests core/play/session/Session.cpp and core/play/session/SessionInputs.cpp, core/play/breaking/Swap.cpp.
#include "core/play/session/Session.h"

#include "core/asset/strength/Threshold.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/play/Sessions.h"

using namespace rubble;
using test::addInput;
using test::floatingBlock;
using test::sessionOf;
using test::throwAtBlock;

namespace {

double massOf(const Session& session) {
    double mass = 0.0;
    for (const PlayBody& body : session.bodies()) mass += session.world().mass(body.body);
    return mass;
}

const PlayBody& projectileOf(const Session& session) {
    return *std::ranges::find(session.bodies(), PlayRole::Projectile, &PlayBody::role);
}

double relative(Vec3 a, Vec3 b) { return glm::distance(a, b) / glm::length(b); }

}  // namespace

class SessionTest : public QObject {
    Q_OBJECT
private slots:
    void bodyBrokenTwiceInAStepBreaksOnce() {
        Session session = test::sessionOf(test::floatingBlock(5));
        test::addInput(session, BreakInput{1});
        test::addInput(session, BreakInput{1});
        session.step();
        QCOMPARE(session.events().breaks.size(), std::size_t{1});
        const std::vector<Diagnostic>& reported = session.events().diagnostics;
        QCOMPARE(reported.size(), std::size_t{1});
        QCOMPARE(reported[0].code, DiagnosticCode::UnappliedInput);
        QCOMPARE(reported[0].place, (DiagnosticPlace{.asset = 2}));
        QCOMPARE(session.bodies().size(), std::size_t{6});  // the fragments and the ground
    }
    void impactAtTheThresholdBreaks_data() {
        QTest::addColumn<double>("share");
        QTest::addColumn<bool>("breaks");
        QTest::newRow("just below") << 0.999 << true;
        QTest::newRow("just above") << 1.001 << false;
    }
    void impactAtTheThresholdBreaks() {
        QFETCH(double, share);
        QFETCH(bool, breaks);
        Project project = floatingBlock();
        const double impulse = 12.0 / (1.0 / 20.0 + 1.0 / 500.0);  // 20 kg at 12 m/s into 500 kg, head on
        project.assets[0].threshold = share * impulse;
        Session session = sessionOf(project);
        addInput(session, ShotInput{"box", throwAtBlock(20.0, 12.0)});
        const std::vector<PlayBreak> broken = test::breaksWithin(session, 20);
        QCOMPARE(broken.size(), breaks ? 1u : 0u);
        if (!breaks) return;
        QVERIFY(std::abs(broken[0].impact - impulse) < 1e-4 * impulse);
        QCOMPARE(session.nameOf(broken[0].body), std::string("block"));
        QVERIFY(glm::distance(broken[0].normal, Vec3(0.0, 0.0, -1.0)) < 1e-6);
        QVERIFY(glm::distance(broken[0].point, Vec3(0.0, 5.0, 0.25)) < 1e-3);
        QCOMPARE(broken[0].fragmentCount, 5u);
        QCOMPARE(session.nameOf(*session.body(broken[0].firstFragment)), std::string("block/3.0"));
    }

    void breakingConservesMassAndMomenta() {
        Project project = floatingBlock(12);
        Session session = sessionOf(project, {.sleeping = false});
        const std::uint32_t block = session.bodies()[1].number;
        const auto hit = [&](Vec3 at, Vec3 impulse) { addInput(session, ShotInput{"hit", Hammer{at, impulse}}); };
        hit({0.4, 5.3, 0.25}, {0.0, 0.0, -90.0});  // each below its threshold: it flies and rotates about all axes
        hit({0.5, 5.2, 0.1}, {-90.0, 0.0, 0.0});
        hit({0.3, 5.5, 0.2}, {0.0, -90.0, 0.0});
        for (int step = 0; step < 20; ++step) session.step();
        const Momenta before = session.world().momenta();
        const double mass = massOf(session);
        addInput(session, BreakInput{block});
        session.step();
        QCOMPARE(session.events().breaks.size(), 1u);
        const Momenta after = session.world().momenta();
        QVERIFY(std::abs(massOf(session) - mass) < 1e-5 * mass);
        QVERIFY2(relative(after.linear, before.linear) < 1e-5,
                 QByteArray::number(relative(after.linear, before.linear)));
        QVERIFY2(relative(after.angular, before.angular) < 1e-5,
                 QByteArray::number(relative(after.angular, before.angular)));
        QVERIFY(std::abs(after.kinetic - before.kinetic) < 1e-3 * before.kinetic);
    }

    void breakingImpactConservesMassAndMomenta() {
        for (const double threshold : {1.0, 50.0, 120.0}) {
            Project project = floatingBlock(12);
            project.assets[0].threshold = threshold;
            Session session = sessionOf(project, {.sleeping = false});
            Throw thrown = throwAtBlock(30.0, 15.0);
            thrown.to = {0.3, 5.2, 0.0};  // not through the middle: everything turns
            thrown.from = {0.6, 5.1, 1.0};
            addInput(session, ShotInput{"box", thrown});
            session.step();
            const Momenta before = session.world().momenta();
            const double mass = massOf(session);
            QVERIFY(!test::breaksWithin(session, 60).empty());
            const Momenta after = session.world().momenta();
            QVERIFY(std::abs(massOf(session) - mass) < 1e-5 * mass);
            QVERIFY(relative(after.linear, before.linear) < 1e-5);
            // The solver's contacts reach across gaps of centimetres, where friction turns what it moves a little.
            QVERIFY(relative(after.angular, before.angular) < 2e-3);
            QVERIFY(after.kinetic < before.kinetic);
        }
    }

    void heavyBoxPassesAThinPane() {
        Project project = floatingBlock(30);
        project.assets[0].prism().depth = 0.01;  // 10 kg
        project.assets[0].threshold = 20.0;
        Session session = sessionOf(project);
        addInput(session, ShotInput{"box", throwAtBlock(100.0, 10.0)});
        QCOMPARE(test::breaksWithin(session, 30).size(), 1u);
        const BodyState box = session.world().state(projectileOf(session).body);
        QVERIFY2(box.velocity.z < -9.0, QByteArray::number(box.velocity.z));  // 20 N·s of 1000 were transferred
        QVERIFY(box.centre.z < -1.0);
    }

    void fixedAndUnbreakableAreTwoSwitches_data() {
        QTest::addColumn<bool>("isFixed");
        QTest::addColumn<bool>("isUnbreakable");
        QTest::newRow("neither") << false << false;
        QTest::newRow("fixed") << true << false;
        QTest::newRow("unbreakable") << false << true;
        QTest::newRow("both") << true << true;
    }
    void fixedAndUnbreakableAreTwoSwitches() {
        QFETCH(bool, isFixed);
        QFETCH(bool, isUnbreakable);
        Project project = floatingBlock();
        project.instances[0].isFixed = isFixed;
        project.instances[0].isUnbreakable = isUnbreakable;
        const ShotInput shots[] = {{"box", throwAtBlock(200.0, 12.0)},
                                   {"hammer", Hammer{{0.0, 5.0, 0.25}, {0.0, 0.0, -500.0}}},
                                   {"blast", Blast{{0.0, 5.0, 1.0}, 1e4, 3.0}}};
        for (const ShotInput& shot : shots) {
            Session session = sessionOf(project);
            addInput(session, shot);
            QCOMPARE(test::breaksWithin(session, 20).size(), isUnbreakable ? 0u : 1u);
            if (!isUnbreakable) continue;
            const bool hasMoved =
                glm::distance(session.world().state(session.bodies()[1].body).centre, Vec3(0.0, 5.0, 0.0)) > 0.01;
            QCOMPARE(hasMoved, !isFixed);
            QVERIFY(std::isinf(session.thresholdOf(session.bodies()[1])));
        }
        Session session = sessionOf(project);
        addInput(session, BreakInput{session.bodies()[1].number});
        QCOMPARE(test::breaksWithin(session, 1).size(), isUnbreakable ? 0u : 1u);
        QCOMPARE(session.events().diagnostics.size(), isUnbreakable ? 1u : 0u);
    }

    void nothingBouncesOffABrokenWall() {
        Project project = floatingBlock();
        project.instances[0].isFixed = true;  // as hard as a wall can be
        project.assets[0].threshold = 100.0;
        Session session = sessionOf(project);
        addInput(session, ShotInput{"box", throwAtBlock(200.0, 12.0)});
        bool hasBroken = false;
        for (int step = 0; step < 60; ++step) {
            session.step();
            hasBroken = hasBroken || !session.events().breaks.empty();
            if (hasBroken) QVERIFY(session.world().state(projectileOf(session).body).velocity.z < 0.0);
        }
        QVERIFY(hasBroken);
    }

    /// A ball of 2 t at 20 m/s. Breaking the gable takes 1.25 m/s; pushing its fragments aside takes the rest.
    void aHeavyBallGoesThroughTheGable() {
        Session session = sessionOf(test::house());
        addInput(session, ShotInput{"ball", Throw{.kind = ProjectileKind::Ball,
                                                  .size = Vec3(1.0),
                                                  .mass = 2000.0,
                                                  .from = {0.0, 4.9, 9.0},
                                                  .to = {0.0, 4.9, 3.0},
                                                  .speed = 20.0}});
        for (int step = 0; step < 45; ++step) session.step();
        const BodyState ball = session.world().state(projectileOf(session).body);
        QVERIFY2(ball.centre.z < 1.5 && ball.velocity.z < -5.0, QByteArray::number(ball.velocity.z));
    }
    void impactorLosesTheBreakImpulse() {
        Project project = floatingBlock();
        project.assets[0].prism().depth = 0.05;  // 50 kg
        project.assets[0].threshold = 200.0;     // of the 400 N·s that the box applies
        Session session = sessionOf(project);
        addInput(session, ShotInput{"box", throwAtBlock(100.0, 12.0)});
        QCOMPARE(test::breaksWithin(session, 20).size(), 1u);
        const double speed = -session.world().state(projectileOf(session).body).velocity.z;
        QVERIFY2(speed < 12.0 - 200.0 / 100.0 && speed > 12.0 - 400.0 / 100.0 - 0.1, QByteArray::number(speed));
    }

    void derivedThresholdsAreUsed() {
        Project project = floatingBlock(7);
        project.assets[0].threshold = 1e6;  // as typed: out of reach
        deriveThreshold(project.assets[0]);
        project.materials[0].tensileStrength = 1.0;
        *project.materials[0].tensileStrength = 200.0 / thresholdOf(project, project.assets[0]);
        Session session = sessionOf(project, {.sleeping = false});
        for (const PlayBody& body : session.bodies()) {
            if (body.role == PlayRole::Instance) QVERIFY(std::abs(session.thresholdOf(body) - 200.0) < 1e-9);
        }
    }
    void bodiesBreakingEachOtherConserveMomenta() {
        Project project = floatingBlock(7);
        project.assets[0].threshold = 100.0;
        project.instances[0].threshold = 300.0;
        Session session = sessionOf(project, {.sleeping = false});
        const Throw thrown{.kind = ProjectileKind::Asset,
                           .asset = project.assets[0].id,
                           .from = {0.2, 5.1, 2.0},
                           .to = {0.2, 5.1, 0.0},
                           .speed = 10.0};
        addInput(session, ShotInput{"other", thrown});
        session.step();
        const Momenta before = session.world().momenta();
        const std::vector<PlayBreak> broken = test::breaksWithin(session, 30);
        QCOMPARE(broken.size(), 2u);
        QCOMPARE(broken[0].step, broken[1].step);
        const Momenta after = session.world().momenta();
        QVERIFY(relative(after.linear, before.linear) < 1e-5);
        QVERIFY(relative(after.angular, before.angular) < 2e-3);  // as above
        QVERIFY(after.kinetic < before.kinetic);
    }

    void momentumRuleBreaksOnGrazingContact() {
        Project project = floatingBlock();
        project.assets[0].threshold = 1000.0;
        Throw thrown = throwAtBlock(1.0, 3.0);  // 3 N·s: nothing by itself
        for (const DamageRule rule : {DamageRule::Impact, DamageRule::Momentum}) {
            project.damage.rule = rule;
            Session session = sessionOf(project);
            const Throw flying{.kind = ProjectileKind::Asset,
                               .asset = project.assets[0].id,
                               .from = {0.0, 5.0, 9.0},
                               .to = {0.0, 5.0, 0.0},
                               .speed = 4.0};
            project.instances.clear();
            Session alone = sessionOf(project);
            addInput(alone, ShotInput{"block", flying});  // 500 kg at 4 m/s: 2000 N·s
            thrown.from = {0.0, 5.0, -1.0};
            thrown.to = {0.0, 5.0, 9.0};
            addInput(alone, ShotInput{"pebble", thrown});
            QCOMPARE(test::breaksWithin(alone, 120).size(), rule == DamageRule::Momentum ? 1u : 0u);
        }
    }

    void thesisPresetCopiesVelocitiesAndUsesEqualMasses() {
        Project project = floatingBlock(6);
        project.damage = {.rule = DamageRule::Momentum, .isThesis = true, .thesisThreshold = 100.0};
        Session session = sessionOf(project, {.sleeping = false});
        addInput(session, ShotInput{"box", throwAtBlock(20.0, 12.0)});
        QCOMPARE(test::breaksWithin(session, 20).size(), 1u);
        for (const PlayBody& body : session.bodies()) {
            if (body.role == PlayRole::Debris) QVERIFY(std::abs(session.world().mass(body.body) - 100.0) < 1e-3);
        }
    }

    void fragmentsBreakInLaterStepsOnly() {
        Project project = floatingBlock(3);
        project.assets[0].threshold = 10.0;
        project.assets[0].levels = {
            {.pattern = {{{.id = 99, .randomSeed = 5, .parameters = UniformScatter{.count = 4}}}}}};
        project.nextId = 100;
        Session session = sessionOf(project);
        Throw against = throwAtBlock(100.0, 20.0);
        against.from.z = -against.from.z - 3.0;  // meets the fragments
        addInput(session, ShotInput{"box", throwAtBlock(100.0, 20.0)});
        addInput(session, ShotInput{"against", against});
        const std::vector<PlayBreak> broken = test::breaksWithin(session, 60);
        QVERIFY(broken.size() >= 2);
        QVERIFY(broken[1].step > broken[0].step);
        QVERIFY(broken[1].threshold < broken[0].threshold);
        QCOMPARE(broken[1].fragmentCount, 4u);
        QVERIFY(session.nameOf(*session.body(broken[1].firstFragment))
                    .starts_with(session.nameOf(broken[1].body) + "/99."));
    }

    /// Each half of a floating box gets a blow of 20 N·s after the box is broken: only one of them is weak enough.
    void fragmentsBreakAtTheirOwnThresholds() {
        Project project = boxProject(PlacedSeeds{{{0, {0.125, 0.5}}, {1, {0.875, 0.5}}}});
        project.gravity = Vec3(0.0);
        project.instances[0].pose.position.y = 5.0;
        project.assets[0].levels = {
            {.pattern = {{{.id = 6, .parameters = UniformScatter{.count = 4}}}}, .threshold = 30.0}};
        project.assets[0].fragmentThresholds = {{"3.1", 15.0}};
        Session session = test::sessionOf(project);
        test::addInput(session, BreakInput{session.bodies().back().number});
        session.step();
        const std::vector<PlayBody> halves(session.bodies().end() - 2, session.bodies().end());
        QCOMPARE(session.thresholdOf(halves[0]), 30.0);
        QCOMPARE(session.thresholdOf(halves[1]), 15.0);
        for (const PlayBody& half : halves) {
            const Vec3 front = session.world().state(half.body).centre + Vec3(0.0, 0.0, 0.25);
            test::addInput(session, ShotInput{"blow", Hammer{.at = front, .impulse = {0.0, 0.0, -20.0}}});
        }
        const std::vector<PlayBreak> breaks = test::breaksWithin(session, 3);
        QCOMPARE(breaks.size(), std::size_t{1});
        QCOMPARE(breaks[0].body.number, halves[1].number);
    }
    void hammersAndBlastsBreak() {
        Project project = floatingBlock();
        Session struck = sessionOf(project, {.sleeping = false});
        addInput(struck, ShotInput{"tap", Hammer{.at = {0.0, 5.0, 0.25}, .impulse = {0.0, 0.0, -99.0}}});
        QVERIFY(test::breaksWithin(struck, 1).empty());
        QVERIFY(std::abs(struck.world().momenta().linear.z + 99.0) < 1e-3);
        addInput(struck, ShotInput{"blow", Hammer{.at = {0.0, 5.0, 0.25}, .impulse = {0.0, 0.0, -150.0}}});
        QCOMPARE(test::breaksWithin(struck, 1).size(), 1u);
        QVERIFY(std::abs(struck.world().momenta().linear.z + 249.0) < 1e-2);
        addInput(struck, ShotInput{"miss", Hammer{.at = {9.0, 5.0, 0.25}, .impulse = {0.0, 0.0, -150.0}}});
        struck.step();
        QCOMPARE(struck.events().diagnostics.size(), 1u);
        QCOMPARE(struck.events().diagnostics[0].code, DiagnosticCode::UnappliedInput);

        Session blown = sessionOf(project);
        addInput(blown, ShotInput{"bomb", Blast{.at = {0.0, 5.0, 2.0}, .impulse = 2000.0, .radius = 5.0}});
        QCOMPARE(test::breaksWithin(blown, 1).size(), 1u);
        QVERIFY(blown.world().momenta().linear.z < -100.0);
    }

    void blastAtTheCentreBreaks() {
        Project project = floatingBlock();
        for (const double beside : {0.0, 1e-6}) {
            Session session = sessionOf(project);
            addInput(session, ShotInput{"bomb", Blast{.at = {beside, 5.0, 0.0}, .impulse = 2000.0, .radius = 5.0}});
            QCOMPARE(test::breaksWithin(session, 1).size(), 1u);
        }
    }

    void bodiesThatLeaveTheWorldAreNamed() {
        Session session = sessionOf(floatingBlock());
        addInput(session, ShotInput{"bomb", Blast{.at = {0.0, 4.0, 0.0}, .impulse = 1e15, .radius = 5.0}});
        std::vector<Diagnostic> reported;
        for (int step = 0; step < 60; ++step) {
            session.step();
            for (const Diagnostic& one : session.events().diagnostics) reported.push_back(one);
            for (const PlayBody& body : session.bodies()) QVERIFY(session.world().isWithinBounds(body.body));
        }
        QVERIFY(reported.size() >= 4u);  // the fragments that the blast sees, and those that they push
        for (const Diagnostic& one : reported) {
            QCOMPARE(one.code, DiagnosticCode::LeftWorld);
            QCOMPARE(one.place.asset, 2u);
            QVERIFY2(one.message.starts_with("\"block/3.") &&
                         one.message.ends_with(" it is farther than 2000 m from the origin."),
                     one.message.c_str());
        }
        QCOMPARE(session.bodies().size(), 6u - reported.size());  // the ground and a fragment that others shadow
    }

    void fastestBodiesBreakIntoAllFragments() {
        Session session = sessionOf(floatingBlock());
        addInput(session, DestructionInput{false});
        // Off centre, so that fragments would be faster than the whole.
        addInput(session, ShotInput{"push", Hammer{.at = {0.4, 5.0, 0.25}, .impulse = {0.0, 0.0, -1e15}}});
        session.step();
        addInput(session, BreakInput{1});
        session.step();
        QCOMPARE(session.events().breaks.size(), 1u);
        QVERIFY(session.events().diagnostics.empty());
        QCOMPARE(test::countOf(session, PlayRole::Debris), 5u);
    }

    void inputsTakeEffectAtOnce() {
        Project project = floatingBlock();
        project.assets[0].threshold = 1e6;
        Session session = sessionOf(project, {.sleeping = false});
        addInput(session, ShotInput{"box", throwAtBlock(20.0, 12.0)});
        addInput(session, ThresholdInput{.asset = project.assets[0].id, .threshold = 50.0});
        QCOMPARE(test::breaksWithin(session, 20).size(), 1u);

        Session falling = sessionOf(project);
        addInput(falling, GravityInput{{0.0, -2.0, 0.0}});
        Material lead = project.materials[0];
        lead.density = 11000.0;
        addInput(falling, MaterialInput{lead});
        for (int step = 0; step < 60; ++step) falling.step();
        const PlayBody& block = falling.bodies()[1];
        QVERIFY(std::abs(falling.world().state(block.body).velocity.y + 2.0) < 1e-3);
        QVERIFY(std::abs(falling.world().mass(block.body) - 5500.0) < 1e-2);

        addInput(falling, GravityInput{Vec3(0.0)});
        addInput(falling,
                 GrabInput{.body = block.number, .point = falling.world().state(block.body).centre, .force = 1e6});
        addInput(falling, DragInput{.to = {3.0, 5.0, 0.0}});
        for (int step = 0; step < 300; ++step) falling.step();
        QVERIFY(glm::distance(falling.world().state(block.body).centre, Vec3(3.0, 5.0, 0.0)) < 0.1);
    }

    void invalidInputsAreRejected_data() {
        QTest::addColumn<QString>("sentence");
        QTest::newRow("asset") << "Saved throw \"a\" throws asset 77, which does not exist.";
        QTest::newRow("threshold") << "Cannot set a threshold: the threshold is 0, but it must be from 1e-09 to 1e+24.";
        QTest::newRow("instance") << "Cannot set a threshold: there is no instance 66.";
        QTest::newRow("material") << "Cannot set a material: there is no material 55.";
        QTest::newRow("gravity")
            << "Cannot set gravity: the gravity is (0, nan, 0), but it must be from -1000 to 1000.";
        QTest::newRow("grab") << "Cannot grab: there is no body 44.";
        QTest::newRow("late") << "An input for step 1 came after 2 steps were done.";
    }
    void invalidInputsAreRejected() {
        QFETCH(QString, sentence);
        Session session = sessionOf(floatingBlock());
        session.step();
        session.step();
        const std::map<std::string, TimedInput> inputs{
            {"asset", {2, ShotInput{"a", Throw{.kind = ProjectileKind::Asset, .asset = 77}}}},
            {"threshold", {2, ThresholdInput{.asset = 2, .threshold = 0.0}}},
            {"instance", {2, ThresholdInput{.instance = 66, .threshold = 1.0}}},
            {"material", {2, MaterialInput{{.id = 55, .name = "x"}}}},
            {"gravity", {2, GravityInput{Vec3(0.0, NAN, 0.0)}}},
            {"grab", {2, GrabInput{.body = 44, .force = 1.0}}},
            {"late", {1, ReleaseInput{}}}};
        const Status added = session.add(inputs.at(QTest::currentDataTag()));
        QVERIFY(!added);
        QCOMPARE(QString::fromStdString(added.error().message), sentence);
    }

    void restoredSnapshotContinuesIdentically() {
        Project project = test::house();
        Session session = sessionOf(project);
        addInput(session, ShotInput{"box", Throw{.size = Vec3(0.6),
                                                 .mass = 200.0,
                                                 .from = {0.0, 2.0, 9.0},
                                                 .to = {1.5, 1.5, 2.75},
                                                 .speed = 25.0}});
        for (int step = 0; step < 30; ++step) session.step();
        const std::shared_ptr<const SessionSnapshot> then = session.snapshot();
        const std::size_t broken = test::breaksWithin(session, 60).size();
        const ContentHash hash = session.hash();
        session.restore(*then);
        QCOMPARE(session.stepsDone(), 30u);
        QCOMPARE(test::breaksWithin(session, 60).size(), broken);
        QVERIFY(session.hash() == hash);
    }

    void resultIsIndependentOfThreadsAndLanes() {
        const std::shared_ptr<const PlayScene> scene = test::playSceneOf(test::house());
        std::optional<ContentHash> hash;
        for (const int threads : {1, 2, 3, 16}) {
            for (const SimdWidth lanes : {SimdWidth::Scalar, SimdWidth::Four, widestSimd()}) {
                Result<Session> session = Session::start(scene, {.threads = threads, .lanes = lanes});
                test::addInput(*session, ShotInput{"box", Throw{.size = Vec3(0.6),
                                                                .mass = 200.0,
                                                                .from = {0.0, 2.0, 9.0},
                                                                .to = {1.5, 1.5, 2.75},
                                                                .speed = 25.0}});
                QVERIFY(!test::breaksWithin(*session, 150).empty());
                if (!hash) hash = session->hash();
                QVERIFY(session->hash() == *hash);
            }
        }
    }
};

RUBBLE_TEST(SessionTest)
#include "SessionTest.moc"
