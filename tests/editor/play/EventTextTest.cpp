#include "editor/play/EventText.h"

#include "tests/support/TestProgram.h"

using namespace rubble;

class EventTextTest : public QObject {
    Q_OBJECT
private slots:
    void sentencesSayWhatHappened_data() {
        QTest::addColumn<PlayEvent>("event");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* sentence, EventKind kind, const char* other, std::uint32_t count = 0,
                            RemovalReason reason = RemovalReason::None) {
            QTest::newRow(sentence) << PlayEvent{.record = {.kind = kind, .count = count, .reason = reason},
                                                 .name = "wall",
                                                 .otherName = other}
                                    << QString(sentence);
        };
        row("wall and ground hit each other", EventKind::Impact, "ground");
        row("wall was hit", EventKind::Impact, "");
        row("3 bond(s) of wall broke", EventKind::Bonds, "", 3);
        row("wall came off", EventKind::Detached, "");
        row("wall broke into 40 fragment(s)", EventKind::Broken, "", 40);
        row("wall broke into 40 fragment(s), hit by box", EventKind::Broken, "box", 40);
        row("wall came to rest", EventKind::Settled, "");
        row("wall was removed", EventKind::Removed, "");
        row("wall was removed: its lifetime as debris ended", EventKind::Removed, "", 0, RemovalReason::Lifetime);
        row("wall was removed: there was too much debris", EventKind::Removed, "", 0, RemovalReason::Budget);
        row("wall was removed: it left the world", EventKind::Removed, "", 0, RemovalReason::LeftWorld);
    }
    void sentencesSayWhatHappened() {
        QFETCH(const PlayEvent, event);
        QTEST(sentenceOf(event), "sentence");
    }
    void bondsAreNoBreaks() {
        QCOMPARE(textOf(BreakCounts{}), "no breaks");
        QCOMPARE(textOf(BreakCounts{.breaks = 2, .fragments = 9}), "2 break(s)");
        QCOMPARE(textOf(BreakCounts{.bonds = 22}), "22 broken bond(s)");
        QCOMPARE(textOf(BreakCounts{.breaks = 1, .fragments = 5, .bonds = 22}), "1 break(s), 22 broken bond(s)");
        const auto event = [](EventKind kind, std::uint32_t count) {
            return std::make_shared<const PlayEvent>(PlayEvent{.record = {.kind = kind, .count = count}});
        };
        const std::vector<EventRef> events{event(EventKind::Bonds, 20), event(EventKind::Broken, 5),
                                           event(EventKind::Bonds, 2)};
        QCOMPARE(countsOf(events), (BreakCounts{.breaks = 1, .fragments = 5, .bonds = 22}));
    }
};

RUBBLE_TEST_WITH(EventTextTest, QCoreApplication)
#include "EventTextTest.moc"
