#include "editor/panels/docks/EventTable.h"

#include "tests/support/TestProgram.h"

#include <QAction>
#include <QApplication>
#include <QHeaderView>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

std::vector<EventRef> manyEvents(std::uint64_t count) {
    std::vector<EventRef> events;
    for (std::uint64_t step = 1; step <= count; ++step) {
        events.push_back(std::make_shared<const PlayEvent>(
            PlayEvent{.record = {.step = step, .energy = static_cast<double>((step * 7) % 100)}, .name = "block"}));
    }
    return events;
}

}  // namespace

class EventTableTest : public QObject {
    Q_OBJECT
private slots:
    void returnActivatesTheSelectedEvent() {
        EventTable table;
        table.show();
        const std::vector<EventRef> events = manyEvents(10);
        table.setEvents(events, 1.0);
        QSignalSpy activated(&table, &EventTable::eventActivated);
        QVERIFY(!table.selectedEvent());
        table.selectRow(3);
        QCOMPARE(table.selectedEvent(), events[3]);
        QTest::keyClick(&table, Qt::Key_Return);
        QCOMPARE(activated.size(), 1);
        QCOMPARE(activated[0][0].value<EventRef>(), events[3]);
    }
    void selectionFollowsItsEvent() {
        EventTable table;
        std::vector<EventRef> events = manyEvents(50);
        table.setEvents(events, 1.0);
        table.selectRow(20);
        const EventRef selected = table.selectedEvent();
        table.sortByColumn(EventModel::kEnergy, Qt::DescendingOrder);
        QCOMPARE(table.selectedEvent(), selected);
        events.erase(events.begin(), events.begin() + 10);  // a filter
        table.setEvents(events, 1.0);
        QCOMPARE(table.selectedEvent(), selected);
        events.erase(events.begin() + 10);
        table.setEvents(events, 1.0);
        QVERIFY(!table.selectedEvent());
    }
    void aTableAtItsEndStaysThere() {
        EventTable table;
        table.resize(600, 200);
        table.show();
        std::vector<EventRef> events = manyEvents(100);
        table.setEvents({events.begin(), events.begin() + 50}, 1.0);
        const QScrollBar& bar = *table.verticalScrollBar();
        QTRY_COMPARE(bar.value(), bar.maximum());
        table.setEvents(events, 1.0);
        QTRY_COMPARE(bar.value(), bar.maximum());
        table.scrollToTop();
        events.push_back(manyEvents(101).back());
        table.setEvents(events, 1.0);
        QCOMPARE(bar.value(), 0);
    }
    void theHeaderShowsAndHidesColumns() {
        EventTable table;
        QCOMPARE(table.hiddenColumns(), EventTable::hiddenByDefault());
        QVERIFY(table.isColumnHidden(EventModel::kThreshold) && !table.isColumnHidden(EventModel::kMass));
        QAction* mass = table.horizontalHeader()->findChild<QAction*>("mass");
        QVERIFY(mass->isChecked());
        mass->trigger();
        QVERIFY(table.isColumnHidden(EventModel::kMass));
        QVERIFY(table.hiddenColumns().contains("mass"));
        table.setHiddenColumns({"kind", "energy", "unknown"});
        QVERIFY(!table.isColumnHidden(EventModel::kKind));  // its header has the menu
        QCOMPARE(table.hiddenColumns(), QStringList{"energy"});
    }
    void columnsAreAsWideAsTheirTitles() {
        const EventTable table;
        for (int column = 0; column < EventModel::kColumns; ++column) {
            if (table.isColumnHidden(column)) continue;
            const int title = table.fontMetrics().horizontalAdvance(
                table.model()->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
            QVERIFY(table.columnWidth(column) > title);
        }
    }
};

RUBBLE_TEST_WITH(EventTableTest, QApplication)
#include "EventTableTest.moc"
