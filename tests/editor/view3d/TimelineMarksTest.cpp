#include "editor/view3d/TimelineMarks.h"

#include "editor/widgets/appearance/EventAppearance.h"
#include "tests/support/TestProgram.h"

#include <QGuiApplication>
#include <QImage>
#include <QPainter>

#include <numeric>

using namespace rubble;

namespace {

EventRef eventAt(std::uint64_t step, EventKind kind = EventKind::Impact) {
    return std::make_shared<const PlayEvent>(PlayEvent{.record = {.step = step, .kind = kind}});
}

}  // namespace

class TimelineMarksTest : public QObject {
    Q_OBJECT
private slots:
    void eventsOfAPixelAreOneMark() {
        const std::vector<EventRef> events{eventAt(0), eventAt(10), eventAt(10, EventKind::Broken), eventAt(11),
                                           eventAt(100)};
        const std::vector<TimelineMark> marks = timelineMarks(events, 0.0, 100.0, 50.0);
        QCOMPARE(marks.size(), 4u);
        QCOMPARE(marks[0], (TimelineMark{.column = 0, .counts = {1}}));
        QCOMPARE(marks[1], (TimelineMark{.column = 5, .counts = {1, 0, 0, 1}}));
        QCOMPARE(marks[2].column, 6);  // 5.5 px
        QCOMPARE(marks[3].column, 50);
        QVERIFY(marks[1].has(EventKind::Broken) && !marks[0].has(EventKind::Broken));
    }
    void onlyVisibleStepsHaveMarks() {
        const std::vector<EventRef> events{eventAt(9), eventAt(10), eventAt(20), eventAt(21)};
        QCOMPARE(timelineMarks(events, 10.0, 20.0, 100.0).size(), 2u);
        QCOMPARE(eventsBetween(events, 9.5, 20.5).size(), 2u);
        QVERIFY(timelineMarks(events, 30.0, 40.0, 100.0).empty());
        QVERIFY(timelineMarks({}, 0.0, 0.0, 100.0).empty());
    }
    void thereAreNoMoreMarksThanPixels() {
        std::vector<EventRef> events;
        for (std::uint64_t step = 0; step < 100'000; ++step) {
            events.push_back(eventAt(step, eventKinds()[step % kEventKinds]));
        }
        const std::vector<TimelineMark> marks = timelineMarks(events, 0.0, 99'999.0, 800.0);
        QCOMPARE(marks.size(), 801u);
        std::uint32_t count = 0;
        for (const TimelineMark& mark : marks) count = std::accumulate(mark.counts.begin(), mark.counts.end(), count);
        QCOMPARE(count, 100'000u);
    }
    /// Each kind stays visible in a column of all kinds, and is drawn as high as no other one.
    void marksOfOneStepAreAllVisible() {
        const QRectF track(4.0, 12.0, 40.0, 6.0);
        std::vector<EventRef> events;
        for (const EventKind kind : {EventKind::Impact, EventKind::Settled, EventKind::Removed}) {
            events.push_back(eventAt(10, kind));
        }
        const QImage all = painted(events, track);
        for (const EventRef& event : events) {
            const QImage one = painted({event}, track);
            QVERIFY(one != painted({}, track));
            for (int y = 0; y < one.height(); ++y) {
                for (int x = 0; x < one.width(); ++x) {
                    if (one.pixelColor(x, y) == colourOf(event->record.kind)) {
                        QCOMPARE(all.pixelColor(x, y), one.pixelColor(x, y));
                    }
                }
            }
        }
    }
    void breaksAreHighestAndOnTop() {
        const QRectF track(4.0, 12.0, 40.0, 6.0);
        const QImage picture = painted({eventAt(10), eventAt(10, EventKind::Broken)}, track);
        for (int y = 3; y < 20; ++y) QCOMPARE(picture.pixelColor(24, y), colourOf(EventKind::Broken));
    }

private:
    static QImage painted(const std::vector<EventRef>& events, const QRectF& track) {
        QImage image(48, 24, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        paintMarks(painter, timelineMarks(events, 0.0, 20.0, track.width()), track);
        return image;
    }
};

RUBBLE_TEST_WITH(TimelineMarksTest, QGuiApplication)
#include "TimelineMarksTest.moc"
