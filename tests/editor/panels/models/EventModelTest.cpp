#include "editor/panels/models/EventModel.h"

#include "tests/support/TestProgram.h"

#include <QAbstractItemModelTester>
#include <QFont>
#include <QGuiApplication>
#include <QIcon>
#include <QSignalSpy>

using namespace rubble;

namespace {

EventRef ref(PlayEvent event) { return std::make_shared<const PlayEvent>(std::move(event)); }

const EventRef kBreak = ref({.record = {.step = 30,
                                        .kind = EventKind::Broken,
                                        .impulse = 200.0,
                                        .speed = 12.0,
                                        .energy = 2500.0,
                                        .mass = 100.0,
                                        .count = 40,
                                        .materials = {1, 2}},
                             .name = "wall",
                             .otherName = "box",
                             .strength = ImpactStrength{.name = "wall", .impact = 200.0, .threshold = 100.0},
                             .milliseconds = 1.5});
const EventRef kWithstood =
    ref({.record = {.step = 60, .kind = EventKind::Impact, .impulse = 50.0, .energy = 12.5, .materials = {1, 1}},
         .name = "pane",
         .strength = ImpactStrength{.name = "pane", .impact = 50.0, .threshold = 100.0}});
const EventRef kRemoved =
    ref({.record = {.step = 90, .kind = EventKind::Removed, .mass = 4.0, .reason = RemovalReason::Budget},
         .name = "wall/3"});
const EventRef kUntold = ref({.record = {.step = 95, .kind = EventKind::Impact, .impulse = 60.0},
                              .name = "door",
                              .strength = ImpactStrength{.name = "door", .impact = 60.0, .threshold = 80.0},
                              .isReported = false});

constexpr double kStep = 1.0 / 60.0;

}  // namespace

class EventModelTest : public QObject {
    Q_OBJECT
private slots:
    void noDataIsThatOfNoRow() {  // for which an empty table asks when its current row is copied
        EventModel model;
        QVERIFY(!model.data(QModelIndex(), Qt::DisplayRole).isValid());
    }
    void rowsShowWhatIsKnown() {
        EventModel model;
        const QAbstractItemModelTester tester(&model);
        model.setMaterials({{.id = 1, .name = "glass"}, {.id = 2, .name = "wood"}});
        model.setEvents({kBreak, kWithstood, kRemoved, kUntold}, kStep);
        const QStringList expected[] = {
            {"Break", "0.50", "wall", "box", "2×", "200\u00a0N·s", "12\u00a0m/s", "2.5\u00a0kJ", "100\u00a0kg", "40",
             "glass, wood", "100\u00a0N·s", "1.5\u00a0ms"},
            {"Impact", "1.00", "pane", "", "0.5×", "50\u00a0N·s", "", "12.5\u00a0J", "", "", "glass", "100\u00a0N·s",
             ""},
            {"Removed", "1.50", "wall/3", "", "", "", "", "", "4\u00a0kg", "", "", "", ""},
            {"Impact", "1.58", "door", "", "0.75×", "60\u00a0N·s", "", "", "", "", "", "80\u00a0N·s", ""}};
        for (int row = 0; row < model.rowCount(); ++row) {
            for (int column = 0; column < EventModel::kColumns; ++column) {
                QCOMPARE(text(model, row, column), expected[row][column]);
            }
        }
    }
    void toolTipsGiveReasons() {
        EventModel model;
        model.setEvents({kBreak, kRemoved, kUntold}, kStep);
        QVERIFY(toolTip(model, 0).contains("2× its threshold of 100\u00a0N·s"));
        QVERIFY(toolTip(model, 1).contains("too much debris"));
        QVERIFY(toolTip(model, 2).contains("not exported"));
        QVERIFY(!toolTip(model, 0).contains("not exported"));
    }
    /// So that a list keeps its place while the simulation runs.
    void newEventsAreInserted() {
        EventModel model;
        const QAbstractItemModelTester tester(&model);
        const QSignalSpy resets(&model, &QAbstractItemModel::modelReset), rows(&model, &EventModel::rowsInserted),
            removed(&model, &EventModel::rowsRemoved);
        model.setEvents({kBreak}, kStep);
        model.setEvents({kBreak, kWithstood, kRemoved}, kStep);
        QCOMPARE(rows.count(), 2);
        model.setEvents({kBreak}, kStep);  // a seek into the past and another throw
        QCOMPARE(removed.count(), 1);
        QCOMPARE(resets.count(), 0);
        model.setEvents({kWithstood}, kStep);  // another course of the simulation
        QCOMPARE(resets.count(), 1);
        QCOMPARE(model.rowCount(), 1);
    }
    void sortsByValueThenTime_data() {
        QTest::addColumn<int>("column");
        QTest::addColumn<Qt::SortOrder>("order");
        QTest::addColumn<QStringList>("bodies");
        const auto row = [](const char* name, int column, Qt::SortOrder order, const QStringList& bodies) {
            QTest::newRow(name) << column << order << bodies;
        };
        row("time", EventModel::kTime, Qt::DescendingOrder, {"door", "wall/3", "pane", "wall"});
        row("kind", EventModel::kKind, Qt::AscendingOrder, {"pane", "door", "wall", "wall/3"});
        row("body", EventModel::kBody, Qt::AscendingOrder, {"door", "pane", "wall", "wall/3"});
        row("other", EventModel::kOther, Qt::DescendingOrder, {"wall", "pane", "wall/3", "door"});
        row("energy", EventModel::kEnergy, Qt::DescendingOrder, {"wall", "pane", "wall/3", "door"});
        row("ratio", EventModel::kRatio, Qt::AscendingOrder, {"wall/3", "pane", "door", "wall"});
        row("materials", EventModel::kMaterials, Qt::DescendingOrder, {"wall", "pane", "wall/3", "door"});
    }
    void sortsByValueThenTime() {
        QFETCH(const int, column);
        QFETCH(const Qt::SortOrder, order);
        QFETCH(const QStringList, bodies);
        const std::vector<EventRef> all{kBreak, kWithstood, kRemoved, kUntold};
        EventModel atOnce, oneByOne;
        const QAbstractItemModelTester tester(&oneByOne);
        for (EventModel* model : {&atOnce, &oneByOne}) {
            model->setMaterials({{.id = 1, .name = "glass"}, {.id = 2, .name = "wood"}});
        }
        atOnce.setEvents(all, kStep);
        const QPersistentModelIndex selected(atOnce.index(0, 0));
        atOnce.sort(column, order);
        QCOMPARE(namesIn(atOnce), bodies);
        QCOMPARE(atOnce.event(selected.row()), kBreak);  // it follows its event
        QCOMPARE(atOnce.rowOf(kBreak), selected.row());
        oneByOne.sort(column, order);
        for (std::size_t count = 1; count <= all.size(); ++count) {
            oneByOne.setEvents({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)}, kStep);
        }
        QCOMPARE(namesIn(oneByOne), bodies);
    }
    void manyNewEventsAreSortedIn() {
        EventModel model;
        model.sort(EventModel::kTime, Qt::DescendingOrder);
        model.setEvents({kBreak}, kStep);
        std::vector<EventRef> events{kBreak};
        for (std::uint64_t step = 31; step < 231; ++step) events.push_back(ref({.record = {.step = step}}));
        model.setEvents(events, kStep);
        QCOMPARE(model.rowCount(), 201);
        QCOMPARE(model.event(0)->record.step, 230u);
        QCOMPARE(model.event(200), kBreak);
    }
    void whatIsNotReportedIsFaint() {
        EventModel model;
        model.setEvents({kBreak, kUntold}, kStep);
        QVERIFY(!model.data(model.index(0, 0), Qt::ForegroundRole).isValid());
        QVERIFY(model.data(model.index(1, 0), Qt::ForegroundRole).isValid());
        QVERIFY(!model.data(model.index(0, 0), Qt::DecorationRole).value<QIcon>().isNull());
    }
    void laterEventsAreInItalics() {
        EventModel model;
        model.setEvents({kBreak, kWithstood, kRemoved}, kStep);
        const QSignalSpy changes(&model, &EventModel::dataChanged);
        model.setDisplayedStep(60);
        QCOMPARE(changes.count(), 1);
        model.setDisplayedStep(61);  // nothing happens between
        QCOMPARE(changes.count(), 1);
        const auto isItalic = [&](int row) {
            return model.data(model.index(row, 0), Qt::FontRole).value<QFont>().italic();
        };
        QVERIFY(!isItalic(0) && !isItalic(1) && isItalic(2));
        QVERIFY(model.data(model.index(2, 0), Qt::ForegroundRole).isValid());
        QVERIFY(toolTip(model, 2).contains("after the displayed time"));
        model.setDisplayedStep(90);
        QVERIFY(!isItalic(2));
    }

private:
    static QString text(const EventModel& model, int row, int column) {
        return model.data(model.index(row, column), Qt::DisplayRole).toString();
    }
    static QString toolTip(const EventModel& model, int row) {
        return model.data(model.index(row, 0), Qt::ToolTipRole).toString();
    }
    static QStringList namesIn(const EventModel& model) {
        QStringList names;
        for (int row = 0; row < model.rowCount(); ++row) names << text(model, row, EventModel::kBody);
        return names;
    }
};

RUBBLE_TEST_WITH(EventModelTest, QGuiApplication)
#include "EventModelTest.moc"
