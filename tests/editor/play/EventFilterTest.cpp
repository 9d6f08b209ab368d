// Tests editor/play/EventFilter.cpp and editor/play/ShownEvents.cpp.
#include "editor/play/ShownEvents.h"

#include "tests/support/TestProgram.h"

using namespace rubble;

namespace {

const PlayEvent kImpact{
    .record = {.step = 10, .kind = EventKind::Impact, .impulse = 5.0, .energy = 12.5, .materials = {3, 0}},
    .name = "front 1.1/5.17",
    .otherName = "ground"};
const PlayEvent kSettled{.record = {.step = 20, .kind = EventKind::Settled, .mass = 4.0, .materials = {4, 0}},
                         .name = "Back"};

std::shared_ptr<const LoggedStep> stepOf(std::uint64_t step, std::vector<PlayEvent> events) {
    for (PlayEvent& event : events) event.record.step = step;
    return std::make_shared<const LoggedStep>(LoggedStep{.step = step, .events = std::move(events)});
}

}  // namespace

class EventFilterTest : public QObject {
    Q_OBJECT
private slots:
    void allIsAcceptedByDefault() {
        const EventFilter filter;
        QVERIFY(!filter.isActive());
        QVERIFY(filter.accepts(kImpact) && filter.accepts(kSettled));
    }
    void kindsAreSwitchedOff() {
        EventFilter filter;
        filter.kinds[static_cast<std::size_t>(EventKind::Settled)] = false;
        QVERIFY(filter.isActive());
        QVERIFY(filter.accepts(kImpact) && !filter.accepts(kSettled));
    }
    void textIsInAName_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("impact");
        QTest::addColumn<bool>("settled");
        QTest::newRow("body") << "front" << true << false;
        QTest::newRow("fragment") << "/5.1" << true << false;
        QTest::newRow("other body") << "Ground" << true << false;
        QTest::newRow("any case") << "bACK" << false << true;
        QTest::newRow("neither") << "roof" << false << false;
    }
    void textIsInAName() {
        QFETCH(const QString, text);
        const EventFilter filter{.text = text};
        QTEST(filter.accepts(kImpact), "impact");
        QTEST(filter.accepts(kSettled), "settled");
    }
    void leastEnergyNeedsAnEnergy() {
        QVERIFY(EventFilter{.leastEnergy = 12.5}.accepts(kImpact));
        QVERIFY(!EventFilter{.leastEnergy = 12.6}.accepts(kImpact));
        QVERIFY(!EventFilter{.leastEnergy = 0.1}.accepts(kSettled));
        PlayEvent unreported = kImpact;
        unreported.isReported = false;
        QVERIFY(!EventFilter{.leastEnergy = 0.1}.accepts(unreported));
    }
    void materialIsOneOfBoth() {
        QVERIFY(EventFilter{.material = 3}.accepts(kImpact));
        QVERIFY(!EventFilter{.material = 3}.accepts(kSettled));
        QVERIFY(EventFilter{.material = 4}.accepts(kSettled));
    }
    void shownEventsFollowTheCourse() {
        EventCourse course;
        ShownEvents shown;
        const auto append = [&](const std::shared_ptr<const LoggedStep>& step) {
            course.append(step);
            shown.append(step);
        };
        append(stepOf(1, {kImpact, kSettled}));
        append(stepOf(5, {kSettled}));
        QCOMPARE(shown.events().size(), 3u);
        EventFilter filter;
        filter.kinds[static_cast<std::size_t>(EventKind::Impact)] = false;
        shown.setFilter(filter, course);
        QCOMPARE(shown.events().size(), 2u);
        append(stepOf(7, {kImpact, kSettled}));
        QCOMPARE(shown.events().size(), 3u);
        QCOMPARE(shown.events().back()->record.step, 7u);
        shown.discardAfter(5);
        QCOMPARE(shown.events().size(), 2u);
        course.discardAfter(5);
        shown.setFilter({}, course);
        QCOMPARE(shown.events().size(), 3u);
        shown.clear();
        QVERIFY(shown.events().empty());
    }
};

RUBBLE_TEST_WITH(EventFilterTest, QCoreApplication)
#include "EventFilterTest.moc"
