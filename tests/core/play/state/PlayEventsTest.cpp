#include "core/play/state/PlayEvents.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

/// One event of each kind, told apart by a number.
PlayEvents eventsOf(std::uint32_t number) {
    PlayEvents events;
    events.breaks.push_back({.body = {.number = number}});
    events.splits.push_back({.body = {.number = number}});
    events.impacts.push_back({.body = number});
    events.born.push_back({.number = number});
    events.removed.push_back({.body = {.number = number}});
    events.energy.push_back({.body = number});
    events.report.restEnergy = number;
    events.report.omitted[0] = {.count = number, .energy = 0.5 * number};
    return events;
}

}  // namespace

class PlayEventsTest : public QObject {
    Q_OBJECT
private slots:
    void intervalsFollowEachOther() {
        PlayEvents step;
        append(eventsOf(1), step);
        append({}, step);
        append(eventsOf(2), step);
        QCOMPARE(step.breaks.size(), 2u);
        QCOMPARE(step.breaks[1].body.number, 2u);
        QCOMPARE(step.splits[0].body.number, 1u);
        QCOMPARE(step.splits[1].body.number, 2u);
        QCOMPARE(step.impacts[1].body, 2u);
        QCOMPARE(step.born[1].number, 2u);
        QCOMPARE(step.removed[1].body.number, 2u);
        QCOMPARE(step.energy[1].body, 2u);
    }
    void sumsAreAdded() {
        PlayEvents step;
        append(eventsOf(1), step);
        append(eventsOf(2), step);
        QCOMPARE(step.report.restEnergy, 3.0);
        QCOMPARE(step.report.omitted[0].count, 3u);
        QCOMPARE(step.report.omitted[0].energy, 1.5);
    }
};

RUBBLE_TEST(PlayEventsTest)
#include "PlayEventsTest.moc"
