// Tests what play and presenting do to the layout in editor/views/Views.cpp and editor/window/MainWindow.cpp.
#include "editor/view3d/TimelinePanel.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/editor/EditorStory.h"

#include <QDockWidget>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>

using namespace rubble;

/// Play and presenting hide docks, toolbars and the canvas, or raise other docks. After them, all is as it was before.
class LayoutStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void init() {
        openBaked(boxProject(UniformScatter{.count = 4}));
        play().thread().useSteppedClock();
        QVERIFY(QTest::qWaitForWindowExposed(&window(), kPatience));
        docks().dock(DockId::Strength).raise();
        docks().dock(DockId::Tests).raise();
        QTRY_VERIFY(isInFront(DockId::Strength) && isInFront(DockId::Tests));
        m_shown = shown();
    }
    void cleanup() { close(); }

    void tabsAreRaisedAgainAfterPlay() {
        start();
        QTRY_VERIFY(isInFront(DockId::Play) && !isInFront(DockId::Tests));
        docks().dock(DockId::PlayTools).raise();
        play().stop();
        QTRY_COMPARE_WITH_TIMEOUT(shown(), m_shown, kPatience);
    }
    void presentingHidesAllButTheScene() {
        action("view-present")->trigger();
        QTRY_COMPARE(shown(), QStringList{"scene"});
        QTest::keyClick(&viewport(), Qt::Key_P, Qt::ControlModifier);  // keys of the menus work
        QTRY_VERIFY_WITH_TIMEOUT(play().isPlaying(), kPatience);
        QCOMPARE(shown(), QStringList{"scene"});
        QTest::keyClick(&viewport(), Qt::Key_Escape);
        QTRY_VERIFY(shown().contains("timeline") && shown().contains("menus") && shown().contains("status"));
        play().stop();
        QTRY_COMPARE_WITH_TIMEOUT(shown(), m_shown, kPatience);
    }
    void playMayBeStartedAndStoppedWhilePresenting() {
        action("view-present")->trigger();
        start();
        QTRY_COMPARE(shown(), QStringList{"scene"});
        play().stop();
        QTRY_VERIFY_WITH_TIMEOUT(!play().isInPlay(), kPatience);
        QCOMPARE(shown(), QStringList{"scene"});
        action("view-present")->trigger();
        QTRY_COMPARE(shown(), m_shown);
    }
    void presentingMayBeginInPlayAndEndAfterIt() {
        start();
        action("view-present")->trigger();
        play().stop();
        QTRY_VERIFY_WITH_TIMEOUT(!play().isInPlay(), kPatience);
        QCOMPARE(shown(), QStringList{"scene"});
        action("view-present")->trigger();
        QTRY_COMPARE(shown(), m_shown);
    }
    void presentingIsNotSavedAsTheLayout() {
        action("view-present")->trigger();
        window().close();
        open(boxProject(UniformScatter{.count = 4}));
        QTRY_COMPARE(shown(), m_shown);
    }

private:
    DockLayout& docks() { return window().views().docks(); }
    PlayController& play() { return window().workspace().play(); }
    void start() {
        play().play();
        QTRY_VERIFY_WITH_TIMEOUT(play().isPlaying(), kPatience);
    }
    bool isInFront(DockId id) { return docks().inFront().contains(&docks().dock(id)); }
    /// The names of the docks in front, of the toolbars and of the views that can be seen.
    QStringList shown() {
        QStringList names;
        for (const QDockWidget* dock : docks().inFront()) names << dock->objectName();
        for (const QToolBar* bar : window().findChildren<QToolBar*>(Qt::FindDirectChildrenOnly)) {
            if (bar->isVisible()) names << bar->objectName();
        }
        if (canvas().isVisible()) names << "canvas";
        if (window().views().scene().isVisible()) names << "scene";
        if (window().views().scene().timeline().isVisible()) names << "timeline";
        if (window().menuBar()->height() > 0) names << "menus";
        if (window().statusBar()->isVisible()) names << "status";
        names.sort();
        return names;
    }

    QStringList m_shown;
};

RUBBLE_TEST_WITH(LayoutStoryTest, QApplication)
#include "LayoutStoryTest.moc"
