#include "editor/play/EventExport.h"

#include "core/io/play/EventStreamFile.h"
#include "editor/play/PlayEngine.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/editor/PlayStage.h"

using namespace rubble;

namespace {

constexpr int kSteps = 90;

/// A simulation of the demo house, in which its first shot breaks something.
test::Stage& playHouse(test::Stage& stage) {
    stage.start();
    stage.controller.fire(stage.document.project().shots.front());
    stage.advance(kSteps);
    return stage;
}

/// What the command line writes for it.
std::string toldBy(const Project& project, EventsFormat format) {
    Session session = test::sessionOf(project);
    test::addInput(session, ShotInput{project.shots.front().name, project.shots.front().action});
    EventsText text(format);
    for (int k = 0; k < kSteps; ++k) {
        session.step();
        text.add(session.stepsDone(), session.events().report);
    }
    return std::move(text).finished();
}

}  // namespace

class EventExportTest : public QObject {
    Q_OBJECT
private slots:
    void allEventsAreTheBytesOfTheCommandLine_data() {
        QTest::addColumn<EventsFormat>("format");
        QTest::newRow("JSON lines") << EventsFormat::JsonLines;
        QTest::newRow("CSV") << EventsFormat::Csv;
    }
    void allEventsAreTheBytesOfTheCommandLine() {
        QFETCH(const EventsFormat, format);
        test::Stage stage(test::house());
        const EventCourse& events = playHouse(stage).controller.events();
        QVERIFY(!events.breaks().empty());
        const std::string expected = toldBy(stage.document.project(), format);
        QVERIFY(eventsText(events, format).value() == expected);
        stage.controller.seek(30);  // the course is the whole timeline, wherever it is displayed
        stage.settle();
        QVERIFY(eventsText(events, format).value() == expected);
    }
    void secondVersionIsTheBytesOfTheCommandLine() {
        test::Stage stage(test::house());
        playHouse(stage);
        Session session = test::sessionOf(stage.document.project());
        const Shot& shot = stage.document.project().shots.front();
        test::addInput(session, ShotInput{shot.name, shot.action});
        EventStreamText expected(session);
        for (int k = 0; k < kSteps; ++k) {
            session.step();
            expected.add(session);
        }
        QVERIFY(eventsText(stage.controller.scene(), stage.script()).value() == expected.take());
    }
    void shownEventsAreExportedWithoutSums() {
        test::Stage stage(test::house());
        playHouse(stage);
        EventFilter filter;
        filter.kinds.fill(false);
        filter.kinds[static_cast<std::size_t>(EventKind::Broken)] = true;
        stage.controller.setEventFilter(filter);
        const std::string text = eventsText(stage.controller.shownEvents(), EventsFormat::JsonLines).value();
        QCOMPARE(std::ranges::count(text, '\n'), static_cast<std::ptrdiff_t>(stage.controller.shownEvents().size()));
        QVERIFY(text.find("\"kind\":\"broken\"") != std::string::npos);
        QVERIFY(text.find("sums") == std::string::npos && text.find("impact\"") == std::string::npos);
    }
    void whatIsNotReportedIsNotExported() {
        const auto unreported = std::make_shared<const PlayEvent>(PlayEvent{.name = "block", .isReported = false});
        QVERIFY(eventsText(std::vector<EventRef>{unreported}, EventsFormat::JsonLines).value().empty());
    }
    void canBeCancelled() {
        const auto event = std::make_shared<const PlayEvent>();
        CancelToken cancel;
        cancel.cancel();
        const Result<std::string> text =
            eventsText(std::vector<EventRef>{event}, EventsFormat::Csv, {.cancel = cancel});
        QCOMPARE(text.error().code, ErrorCode::Cancelled);
    }
};

RUBBLE_TEST_WITH(EventExportTest, QCoreApplication)
#include "EventExportTest.moc"
