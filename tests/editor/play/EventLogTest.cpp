// Tests editor/play/EventLog.cpp and editor/play/EventCourse.cpp.
#include "editor/play/EventLog.h"

#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"

#include <algorithm>

using namespace rubble;

namespace {

/// A block that falls on the ground, with this threshold, and its log.
struct Fall {
    explicit Fall(double threshold, std::size_t maxEvents = kMaxLoggedEvents)
        : log(maxEvents), session(test::sessionOf(fallingBlock(threshold))) {}
    void play(int steps) {
        for (int k = 0; k < steps; ++k) {
            session.step();
            log.record(session);
        }
    }
    std::vector<EventRef> eventsOf(EventKind kind) const {
        std::vector<EventRef> events;
        for (const auto& step : log.course().steps()) {
            for (const PlayEvent& event : step->events) {
                if (event.record.kind == kind) events.emplace_back(step, &event);
            }
        }
        return events;
    }
    static Project fallingBlock(double threshold) {
        Project project = test::floatingBlock();
        project.gravity = {0.0, -10.0, 0.0};
        project.assets[0].threshold = threshold;
        return project;
    }

    EventLog log;
    Session session;
};

EventReport sumOf(const EventReport& report) { return {.omitted = report.omitted, .restEnergy = report.restEnergy}; }

}  // namespace

class EventLogTest : public QObject {
    Q_OBJECT
private slots:
    void withstoodImpactsHaveTheirStrength() {
        Fall fall(1e6);
        fall.play(240);
        const std::vector<EventRef> impacts = fall.eventsOf(EventKind::Impact);
        QVERIFY(!impacts.empty());
        const PlayEvent& impact = *impacts.front();
        QVERIFY(impact.isReported && impact.record.energy > 1000.0);
        QCOMPARE(impact.name, "block");
        QCOMPARE(impact.otherName, "ground");
        QCOMPARE(impact.strength->threshold, 1e6);
        QVERIFY(impact.strength->ratio() < 0.1);
        QCOMPARE(fall.eventsOf(EventKind::Settled).size(), 1u);
        QCOMPARE(fall.log.steps(), 240u);
    }
    void breaksHaveTheirStrengthAndName() {
        Fall fall(100.0);
        fall.play(240);
        QCOMPARE(fall.log.course().breaks().size(), 1u);
        const PlayEvent& broken = *fall.log.course().breaks().front();
        QVERIFY(broken.isReported && broken.strength->ratio() > 1.0);
        QCOMPARE(broken.name, "block");  // which is gone by then
        QCOMPARE(broken.record.count, 5u);
        QVERIFY(fall.log.course().breaks(broken.record.step - 1).empty());
        QCOMPARE(fall.log.course().breaks(broken.record.step).size(), 1u);
    }
    /// A hammer is no body: the session reports no impact.
    void blowsThatBreakNothingAreListed() {
        Project project = test::floatingBlock();
        project.assets[0].threshold = 1000.0;
        Session session = test::sessionOf(project);
        EventLog log;
        const auto strike = [&](double impulse) {
            test::addInput(session, ShotInput{"blow", Hammer{.at = {0.0, 5.0, 0.25}, .impulse = {0.0, 0.0, -impulse}}});
            session.step();
            log.record(session);
        };
        strike(99.0);  // less than a tenth
        QCOMPARE(log.course().size(), 0u);
        strike(300.0);
        QCOMPARE(log.course().size(), 1u);
        const PlayEvent& blow = log.course().steps().back()->events.front();
        QVERIFY(!blow.isReported && !blow.hasEnergy());
        QVERIFY(blow.strength->ratio() > 0.1);
        QVERIFY(EventCourse::reportOf(*log.course().steps().back()).records.empty());
    }
    /// At most 16 events of a step are reported; the list has all breaks.
    void allBreaksAreListed() {
        Project project = test::floatingBlock(2);
        const Id asset = project.assets[0].id;
        for (int k = 1; k < 40; ++k) {
            test::addInstance(project, asset, "block " + std::to_string(k), {.position = {3.0 * k, 5.0, 0.0}});
        }
        Session session = test::sessionOf(project);
        for (const PlayBody& body : session.bodies()) {
            if (body.role == PlayRole::Instance) test::addInput(session, BreakInput{body.number});
        }
        EventLog log;
        session.step();
        log.record(session);
        QCOMPARE(log.course().breaks().size(), 40u);
        const auto reported =
            std::ranges::count_if(log.course().breaks(), [](const EventRef& one) { return one->isReported; });
        QVERIFY(reported < 40);
        QCOMPARE(EventCourse::reportOf(*log.course().steps().back()), session.events().report);
    }
    void reportsAreThoseOfTheSession() {
        Fall fall(100.0);
        std::vector<EventReport> reported;
        for (int k = 0; k < 240; ++k) {
            fall.play(1);
            if (!fall.session.events().report.isEmpty()) reported.push_back(fall.session.events().report);
        }
        std::vector<EventReport> logged;
        OmittedEvents impacts;
        for (const auto& step : fall.log.course().steps()) {
            logged.push_back(EventCourse::reportOf(*step));
            impacts.count += step->omitted[0].count;
        }
        QCOMPARE(logged, reported);
        QCOMPARE(fall.log.course().omitted()[0].count, impacts.count);
    }
    void discardingForgetsTheRest() {
        Fall fall(100.0);
        fall.play(240);
        const std::uint64_t broken = fall.log.course().breaks().front()->record.step;
        EventLog branch = fall.log;
        branch.discardAfter(broken - 1);
        QCOMPARE(branch.steps(), broken - 1);
        QVERIFY(branch.course().breaks().empty());
        std::size_t count = 0;
        double rest = 0.0;
        for (const auto& step : branch.course().steps()) {
            QVERIFY(step->step < broken);
            count += step->events.size();
            rest += step->restEnergy;
        }
        QCOMPARE(branch.course().size(), count);
        QCOMPARE(branch.course().restEnergy(), rest);
        QCOMPARE(fall.log.course().breaks().size(), 1u);
        if (!branch.course().steps().empty()) {  // copies share their steps
            QCOMPARE(branch.course().steps().front(), fall.log.course().steps().front());
        }
    }
    void aFullLogSumsAllButBreaks() {
        Fall fall(100.0), limited(100.0, 1);
        fall.play(240);
        limited.play(240);
        QVERIFY(limited.log.course().size() < fall.log.course().size());
        QCOMPARE(limited.log.course().breaks().size(), 1u);
        EventReport all, sums;
        for (const auto& step : fall.log.course().steps()) add(all, EventCourse::reportOf(*step));
        for (const auto& step : limited.log.course().steps()) add(sums, EventCourse::reportOf(*step));
        QCOMPARE(sumOf(sums).omitted[0].count + sums.records.size() + sums.omitted[4].count,
                 all.omitted[0].count + all.records.size() + all.omitted[4].count);
        QVERIFY(std::abs(sums.energy() - all.energy()) < 1e-9 * all.energy());
    }

private:
    static void add(EventReport& sum, const EventReport& report) {
        sum.records.insert(sum.records.end(), report.records.begin(), report.records.end());
        sum.restEnergy += report.restEnergy;
        for (std::size_t kind = 0; kind < kEventKinds; ++kind) {
            sum.omitted[kind].count += report.omitted[kind].count;
            sum.omitted[kind].energy += report.omitted[kind].energy;
        }
    }
};

RUBBLE_TEST_WITH(EventLogTest, QCoreApplication)
#include "EventLogTest.moc"
