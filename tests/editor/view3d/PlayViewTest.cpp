#include "editor/view3d/PlayView.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/PlayStage.h"
#include "viewport/widget/ViewportWidget.h"

#include <QApplication>
#include <QOpenGLWidget>
#include <QTest>

using namespace rubble;

class PlayViewTest : public QObject {
    Q_OBJECT
private slots:
    /// Of half a second of the stage's clock.
    void framesThatAreDrawnAreCounted() {
        test::Stage stage;
        ViewportWidget viewport;
        PlayView view(stage.controller, viewport);
        stage.start();
        view.refresh();
        for (int k = 0; k < 50; ++k) view.refresh();  // the viewport is hidden: nothing is drawn
        stage.advance(60);
        view.refresh();
        QVERIFY2(view.hud().accessibleText().contains("0 fps"), qPrintable(view.hud().accessibleText()));
        for (int k = 0; k < 30; ++k) emit viewport.drawn();
        stage.advance(60);
        view.refresh();
        QVERIFY2(view.hud().accessibleText().contains("30 fps"), qPrintable(view.hud().accessibleText()));
    }
};

RUBBLE_TEST_WITH(PlayViewTest, QApplication)
#include "PlayViewTest.moc"
