// Tests core/play/events/EventHistory.cpp.
#include "core/play/events/EventHistory.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

EventRecord impact(std::uint64_t step, std::uint32_t body = 1) { return {.step = step, .body = body}; }

/// A history of the steps 1 to `last`, of which each reports an impact.
EventHistory historyUntil(std::uint64_t last, std::size_t mostRecords = 1000) {
    EventHistory history(mostRecords);
    for (std::uint64_t step = 1; step <= last; ++step) history.add(step, std::vector{impact(step)});
    return history;
}

std::size_t countOf(const EventHistory& history, std::uint64_t first = 0, std::uint64_t last = 1000) {
    return history.between(first, last).size();
}

}  // namespace

class EventHistoryTest : public QObject {
    Q_OBJECT
private slots:
    void recordsAreFoundByStep() {
        const EventHistory history = historyUntil(9);
        QCOMPARE(countOf(history, 3, 5), std::size_t{3});
        QCOMPARE(history.between(3, 5).front().step, std::uint64_t{3});
        QCOMPARE(countOf(history, 10, 20), std::size_t{0});
        QCOMPARE(countOf(history, 5, 3), std::size_t{0});
        QCOMPARE(countOf(EventHistory()), std::size_t{0});
    }
    void onlyImpactsAndBreaksAreKept() {
        EventHistory history;
        history.add(1, std::vector{impact(1), EventRecord{.step = 1, .kind = EventKind::Broken},
                                   EventRecord{.step = 1, .kind = EventKind::Settled},
                                   EventRecord{.step = 1, .kind = EventKind::Removed}});
        QCOMPARE(countOf(history), std::size_t{2});
    }
    void stepThatIsPlayedAgainKeepsTheLaterOnes() {
        EventHistory history = historyUntil(9);
        history.add(4, std::vector{impact(4)});
        QCOMPARE(countOf(history), std::size_t{9});
    }
    void otherCourseReplacesTheLaterSteps() {
        EventHistory history = historyUntil(9);
        history.add(5, PlayEvents{});  // nothing happened this time
        QCOMPARE(countOf(history), std::size_t{4});
        history.add(6, std::vector{impact(6, 7)});
        QCOMPARE(history.between(6, 6).front().body, 7u);
        QCOMPARE(countOf(history), std::size_t{5});
    }
    void gapBeginsTheHistoryAnew() {
        EventHistory history = historyUntil(9);
        history.add(11, std::vector{impact(11)});
        QCOMPARE(countOf(history), std::size_t{1});
        history.add(2, std::vector{impact(2)});
        QCOMPARE(countOf(history), std::size_t{1});
        QCOMPARE(history.between(0, 1000).front().step, std::uint64_t{2});
    }
    /// Also where no record tells that the step was another one.
    void blastsAreKeptWithTheirSteps() {
        EventHistory history = historyUntil(9);
        PlayEvents events;
        events.inputs = {
            {8, ShotInput{"blast", Blast{.radius = 3.0}}}, {8, ShotInput{"blow", Hammer{}}}, {8, BreakInput{1}}};
        history.add(10, events);
        history.add(11, PlayEvents{});
        QCOMPARE(history.blastsBetween(1, 11).size(), std::size_t{1});
        QCOMPARE(history.blastsBetween(10, 10).front().blast.radius, 3.0);
        QCOMPARE(history.blastsBetween(11, 20).size(), std::size_t{0});
        history.add(10, events);
        QCOMPARE(countOf(history), std::size_t{9});
        history.add(5, std::vector{impact(5)}, std::vector{BlastRecord{5, {}}});  // another course
        QCOMPARE(countOf(history), std::size_t{5});
        QCOMPARE(history.blastsBetween(1, 20).size(), std::size_t{1});
        history.add(20, PlayEvents{});  // a gap
        QCOMPARE(history.blastsBetween(1, 20).size(), std::size_t{0});
    }
    void oldestStepsAreForgotten() {
        const EventHistory history = historyUntil(100, 20);
        QVERIFY(countOf(history) <= 20 && countOf(history, 92, 100) == 9);
        for (std::uint64_t step = 1; step <= 40; ++step) QVERIFY(countOf(historyUntil(step, 20)) <= 20);
    }
};

RUBBLE_TEST(EventHistoryTest)
#include "EventHistoryTest.moc"
