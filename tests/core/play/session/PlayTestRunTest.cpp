#include "core/play/session/PlayTestRun.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/play/BondedWalls.h"
#include "tests/support/play/MortarPortal.h"
#include "tests/support/play/Sessions.h"

using namespace rubble;

namespace {

/// A test of the house with one shot, and with one expectation of an instance by name.
struct Case {
    std::string shot;  // empty: none
    ExpectationKind kind = ExpectationKind::Breaks;
    std::string instance;  // empty: any
    double value = 0.0;
    double duration = 3.0;
};

ExpectationOutcome outcomeOf(const Case& one) {
    static const std::shared_ptr<const PlayScene> scene = test::playSceneOf(test::house());
    const Project& project = scene->project;
    PlayTest test{.id = 1, .name = "test", .duration = one.duration};
    for (const Shot& shot : project.shots) {
        if (shot.name == one.shot) test.shots.push_back(shot.id);
    }
    Expectation expectation{.kind = one.kind, .value = one.value};
    for (const Instance& instance : project.instances) {
        if (instance.name == one.instance) expectation.instance = instance.id;
    }
    test.expectations = {expectation};
    Result<PlayTestOutcome> outcome = runPlayTest(scene, test);
    if (!outcome) qFatal("%s", outcome.error().message.c_str());
    if (outcome->isPassed() != outcome->expectations[0].isMet) qFatal("a test passes when all is met");
    return outcome->expectations[0];
}

const std::string kDoor = "box at the door", kRoof = "block under the roof", kBall = "ball at the gable";

}  // namespace

class PlayTestRunTest : public QObject {
    Q_OBJECT
private slots:
    void expectations_data() {
        using enum ExpectationKind;
        QTest::addColumn<int>("number");
        QTest::addColumn<bool>("isMet");
        QTest::addColumn<QString>("seen");
        const auto add = [&](const char* name, const Case& one, bool isMet, const char* seen) {
            QTest::newRow(name) << static_cast<int>(m_cases.size()) << isMet << QString(seen);
            m_cases.push_back(one);
        };
        add("stands", {"", StandsUntouched, "", 3.0}, true, "everything stayed intact");
        add("rattles", {kBall, StandsUntouched, "roof back left", 3.0}, true, "it stayed intact");
        add("does not stand", {kRoof, StandsUntouched, "", 2.0}, false, "\"left 3.2\" broke at step 38 (0.6333 s)");
        add("stands until then", {kRoof, StandsUntouched, "", 0.6}, true, "everything stayed intact");
        add("too short", {"", StandsUntouched, "", 9.0, 1.0}, false, "the test ended earlier");
        add("breaks", {kDoor, Breaks, "front 4.1"}, true, "\"front 4.1\" broke at step 47 (0.7833 s)");
        add("any breaks", {kDoor, Breaks}, true, "\"front 4.1\" broke at step 47 (0.7833 s)");
        add("another breaks", {kDoor, Breaks, "back 1.1"}, false, "it did not break");
        add("does not break", {kDoor, DoesNotBreak, "back 1.1"}, true, "it did not break");
        add("nothing breaks", {kBall, DoesNotBreak}, true, "nothing broke");
        add("something breaks", {kDoor, DoesNotBreak}, false, "\"front 4.1\" broke at step 47 (0.7833 s)");
        add("into four", {kDoor, BreaksIntoAtLeast, "front 4.1", 4.0}, true, "it broke into 4 fragments");
        add("into five", {kDoor, BreaksIntoAtLeast, "front 4.1", 5.0}, false, "it broke into 4 fragments");
        add("into any", {kDoor, BreaksIntoAtLeast, "back 1.1", 2.0}, false, "it did not break");
        add("high", {"", NothingAbove, "", 5.0}, false, "");
        add("not so high", {"", NothingAbove, "", 6.0}, true, "");
        add("at rest", {"", NothingFaster, "", 0.01}, true, "");
        add("in flight", {kDoor, NothingFaster, "", 1.0, 0.6}, false, "");
    }
    void expectations() {
        QFETCH(int, number);
        QFETCH(bool, isMet);
        QFETCH(QString, seen);
        const ExpectationOutcome outcome = outcomeOf(m_cases[static_cast<std::size_t>(number)]);
        QVERIFY2(outcome.isMet == isMet, (outcome.expected + ": " + outcome.seen).c_str());
        if (!seen.isEmpty()) QCOMPARE(QString::fromStdString(outcome.seen), seen);
    }

    void outcomeDescribesExpectedAndObserved() {
        const ExpectationOutcome outcome = outcomeOf({kDoor, ExpectationKind::NothingAbove, "front gable", 4.5});
        QCOMPARE(outcome.expected, std::string("\"front gable\" ends below a height of 4.5 m"));
        QVERIFY2(outcome.seen.starts_with("\"front gable\" reached up to 5.4"), outcome.seen.c_str());
        QCOMPARE(outcome.step, 180u);
    }

    void cancellationStops() {
        const CancelToken cancel;
        cancel.cancel();
        const auto outcome = runPlayTest(test::playSceneOf(test::floatingBlock()), {}, {}, {.cancel = cancel});
        QCOMPARE(outcome.error().code, ErrorCode::Cancelled);
    }

    /// The front is broken there: it cannot break again, and times of shots count from there.
    void startsFromAState() {
        const std::shared_ptr<const PlayScene> scene = test::playSceneOf(test::house());
        const auto& shots = scene->project.shots;
        PlayTest test{.id = 1, .name = "test", .duration = 2.0};
        test.shots = {std::ranges::find(shots, kDoor, &Shot::name)->id};
        test.expectations = {{.kind = ExpectationKind::Breaks},
                             {.kind = ExpectationKind::StandsUntouched, .value = 0.1}};
        Result<Session> before = sessionOf(scene, test);
        for (int step = 0; step < 300; ++step) before->step();
        const SavedSession state = savedSession(*before, StateKind::Whole);
        Session expected = *resumedSession(scene, state);
        QVERIFY(expected.add(TimedInput{300 + stepOf(scene->project.shots[0].time, expected.stepLength()),
                                        ShotInput{shots[0].name, shots[0].action}}));
        test.shots = {shots[0].id};
        const Result<PlayTestOutcome> outcome = runPlayTest(scene, test, {}, {}, &state);
        QVERIFY2(outcome.hasValue(), outcome ? "" : outcome.error().message.c_str());
        std::uint64_t broken = 0;
        for (int step = 0; step < 120; ++step) {
            expected.step();
            if (broken == 0 && !expected.events().breaks.empty()) broken = expected.stepsDone();
        }
        QCOMPARE(outcome->steps, std::uint64_t{120});
        QVERIFY(outcome->hash == expected.hash());
        QCOMPARE(outcome->expectations[0].isMet, broken > 0);
        if (broken > 0) QCOMPARE(outcome->expectations[0].step, broken);
        QVERIFY2(outcome->expectations[1].isMet, outcome->expectations[1].seen.c_str());
    }
    void bondedInstancesBreakWhereBondsDo() {
        using enum ExpectationKind;
        Project project = test::bondedWall();
        const Id wall = project.instances[0].id;
        const Id ball = test::addShot(project, "ball", 0.0, test::ballAtWall());
        const auto scene = test::playSceneOf(project);
        Session session = test::sessionOf(project);
        test::addInput(session, ShotInput{"ball", test::ballAtWall()});
        std::uint64_t broken = 0;
        std::size_t bodies = 1;
        for (int k = 0; k < 120; ++k) {
            session.step();
            for (const PlaySplit& split : session.events().splits) {
                if (broken == 0) broken = session.stepsDone();
                bodies += split.freed.size();
            }
        }
        QVERIFY(broken > 0 && bodies > 2);
        const double fragments = static_cast<double>(bodies);
        const PlayTest test{.id = 1,
                            .name = "test",
                            .shots = {ball},
                            .duration = 2.0,
                            .expectations = {{.kind = Breaks, .instance = wall},
                                             {.kind = DoesNotBreak, .instance = wall},
                                             {.kind = StandsUntouched, .instance = wall, .value = 2.0},
                                             {.kind = BreaksIntoAtLeast, .instance = wall, .value = fragments},
                                             {.kind = BreaksIntoAtLeast, .instance = wall, .value = fragments + 1.0}}};
        const Result<PlayTestOutcome> outcome = runPlayTest(scene, test);
        QVERIFY(outcome.hasValue());
        std::vector<bool> areMet;
        for (const ExpectationOutcome& one : outcome->expectations) areMet.push_back(one.isMet);
        QCOMPARE(areMet, (std::vector<bool>{true, false, false, true, false}));
        QCOMPARE(outcome->expectations[0].step, broken);
    }
    void holesAndWhatStaysUp() {
        using enum ExpectationKind;
        Project project = test::bondedWall();
        const Id wall = project.instances[0].id;
        const Id ball = test::addShot(project, "ball", 0.0, test::ballAtWall());
        const PlayTest test{.id = 1,
                            .name = "test",
                            .shots = {ball},
                            .duration = 2.0,
                            .expectations = {{.kind = StaysUp, .instance = wall, .value = 0.3},
                                             {.kind = StaysUp, .value = 0.001},
                                             {.kind = HoleAtMost, .instance = wall, .value = 2.0},
                                             {.kind = HoleAtMost, .value = 0.1}}};
        const Result<PlayTestOutcome> outcome = runPlayTest(test::playSceneOf(project), test);
        QVERIFY(outcome.hasValue());
        std::vector<bool> areMet;
        for (const ExpectationOutcome& one : outcome->expectations) areMet.push_back(one.isMet);
        QCOMPARE(areMet, (std::vector<bool>{true, false, true, false}));
        QCOMPARE(outcome->expectations[0].expected, std::string("\"wall\" loses at most 30 % of its mass"));
        QVERIFY2(outcome->expectations[1].seen.starts_with("\"wall\" lost "), outcome->expectations[1].seen.c_str());
        QCOMPARE(outcome->expectations[3].expected, std::string("every instance has holes of at most 0.1 m"));
        QVERIFY2(outcome->expectations[3].seen.starts_with("\"wall\" has one of "),
                 outcome->expectations[3].seen.c_str());
    }
    void whatIsRemovedIsNotLost() {
        using enum ExpectationKind;
        Project project = test::mortarPortal();
        const Id left = project.instances[0].id, right = project.instances[1].id, beam = project.instances[2].id;
        const auto areMet = [&](const std::vector<InstancePart>& removed) {
            const PlayTest test{
                .id = 1,
                .name = "test",
                .removed = removed,
                .duration = 2.0,
                .expectations = {{.kind = StaysUp, .instance = beam, .value = 0.01}, {.kind = StaysUp, .value = 0.01}}};
            const Result<PlayTestOutcome> outcome = runPlayTest(test::playSceneOf(project), test);
            return std::vector<bool>{outcome->expectations[0].isMet, outcome->expectations[1].isMet};
        };
        QCOMPARE(areMet({}), (std::vector<bool>{true, true}));
        QCOMPARE(areMet({{left, {}}}), (std::vector<bool>{true, true}));
        QCOMPARE(areMet({{left, {}}, {right, {}}}), (std::vector<bool>{false, false}));
    }
    void mortarToWhatIsRemovedIsNoBreak() {
        Project project = test::mortarPortal();
        const Id left = project.instances[0].id, right = project.instances[1].id, beam = project.instances[2].id;
        const auto seen = [&](const std::vector<InstancePart>& removed) {
            const PlayTest test{.id = 1,
                                .name = "test",
                                .removed = removed,
                                .duration = 0.5,
                                .expectations = {{.kind = ExpectationKind::DoesNotBreak, .instance = beam}}};
            return runPlayTest(test::playSceneOf(project), test)->expectations[0].seen;
        };
        QCOMPARE(seen({{left, {}}}), std::string("it did not break"));
        QCOMPARE(seen({{left, {}}, {right, {}}}), std::string("\"beam\" broke at step 1 (0.01667 s)"));
    }

private:
    std::vector<Case> m_cases;
};

RUBBLE_TEST(PlayTestRunTest)
#include "PlayTestRunTest.moc"
