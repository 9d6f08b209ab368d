#include "editor/views/DockLayout.h"

#include "tests/support/TestProgram.h"
#include "tests/support/editor/TestSettings.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace rubble;

namespace {

/// A visible window with all docks in the default layout.
struct DockBench {
    DockBench() : docks(window) {
        for (std::size_t k = 0; k < kDockCount; ++k) {
            docks.add(static_cast<DockId>(k), QString("Dock %1").arg(k), new QWidget);
        }
        docks.reset();
        window.setCentralWidget(new QWidget);
        window.resize(1000, 800);
        window.show();
    }
    bool isHidden(DockId id) { return docks.dock(id).isHidden(); }

    QMainWindow window;
    DockLayout docks;
};

}  // namespace

class DockLayoutTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        test::keepSettingsIn(m_folder->path());
    }

    void defaultLayoutTabsTheBottomDocks() {
        DockBench bench;
        const QList<QDockWidget*> behind = bench.window.tabifiedDockWidgets(&bench.docks.dock(DockId::Fragments));
        QCOMPARE(behind.size(), 4);
        QVERIFY(behind.contains(&bench.docks.dock(DockId::Tests)));
        QCOMPARE(bench.window.dockWidgetArea(&bench.docks.dock(DockId::History)), Qt::LeftDockWidgetArea);
    }
    void toggleHidesAlsoOtherDocks() {
        DockBench bench;
        QDockWidget other("Changes", &bench.window);
        bench.window.addDockWidget(Qt::RightDockWidgetArea, &other);
        other.show();
        bench.docks.toggle();
        QVERIFY(other.isHidden());
        bench.docks.toggle();
        QVERIFY(!other.isHidden());
    }
    void toggleHidesAllAndShowsThemAgain() {
        DockBench bench;
        bench.docks.dock(DockId::History).hide();
        bench.docks.toggle();
        for (std::size_t k = 0; k < kDockCount; ++k) QVERIFY(bench.isHidden(static_cast<DockId>(k)));
        bench.docks.toggle();
        QVERIFY(!bench.isHidden(DockId::Project));
        QVERIFY(bench.isHidden(DockId::History));  // it was hidden before
    }
    void toggleShowsTheSameTabsInFront() {
        DockBench bench;
        QVERIFY(QTest::qWaitForWindowExposed(&bench.window, kPatience));
        const QList<QDockWidget*> raised{&bench.docks.dock(DockId::PlayTools), &bench.docks.dock(DockId::Tests)};
        DockLayout::raise(raised);
        const auto areInFront = [&] {
            const QList<QDockWidget*> front = bench.docks.inFront();
            return front.size() == 4 && front.contains(raised[0]) && front.contains(raised[1]);
        };
        QTRY_VERIFY(areInFront());
        bench.docks.toggle();
        QVERIFY(bench.docks.inFront().isEmpty());
        bench.docks.toggle();
        QTRY_VERIFY(areInFront());
    }
    void actionRaisesADockBehindAnotherAndHidesItInFront() {
        DockBench bench;
        QVERIFY(QTest::qWaitForWindowExposed(&bench.window, kPatience));
        QDockWidget& play = bench.docks.dock(DockId::Play);
        QAction* action = bench.docks.actions()[static_cast<int>(DockId::Play)];
        QVERIFY(play.visibleRegion().isEmpty());
        action->trigger();
        QTRY_VERIFY(!play.visibleRegion().isEmpty());
        action->trigger();
        QVERIFY(play.isHidden());
    }
    void savedLayoutIsRestored() {
        {
            DockBench bench;
            bench.docks.dock(DockId::Messages).hide();
            bench.docks.save();
        }
        DockBench bench;
        QVERIFY(!bench.isHidden(DockId::Messages));
        QVERIFY(bench.docks.restore());
        QVERIFY(bench.isHidden(DockId::Messages));
    }
    void withoutASavedLayoutNothingIsRestored() { QVERIFY(!DockBench().docks.restore()); }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

RUBBLE_TEST_WITH(DockLayoutTest, QApplication)
#include "DockLayoutTest.moc"
