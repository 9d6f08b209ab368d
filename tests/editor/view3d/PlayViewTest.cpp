#include "editor/view3d/PlayView.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/PlayStage.h"
#include "tests/support/play/RestingProjects.h"
#include "viewport/widget/ViewportWidget.h"

#include <QApplication>
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
        view.setStatisticsShown(true);
        stage.start();
        view.refresh();
        for (int k = 0; k < 50; ++k) view.refresh();  // the viewport is hidden: nothing is drawn
        stage.advance(60);
        view.refresh();
        QVERIFY2(view.hud().accessibleText().contains("– fps"), qPrintable(view.hud().accessibleText()));
        for (int k = 0; k < 30; ++k) emit viewport.drawn();
        stage.advance(60);
        view.refresh();
        QVERIFY2(view.hud().accessibleText().contains("30 fps"), qPrintable(view.hud().accessibleText()));
    }
    /// So that it is refined, as while nothing is played.
    void sceneAtRestIsNotShownAgain() {
        test::Stage stage;
        ViewportWidget viewport;
        PlayView view(stage.controller, viewport);
        stage.start();
        stage.advance(5);
        view.refresh();
        const RenderScene* shown = &viewport.scene();
        QVERIFY(!shown->poses.empty() && !isMoving(*shown));
        stage.advance(5);
        view.refresh();
        QCOMPARE(&viewport.scene(), shown);
        stage.controller.throwAlong(test::kAtBlock);
        stage.advance(5);
        view.refresh();
        QVERIFY(&viewport.scene() != shown);
        QVERIFY(isMoving(viewport.scene()));
    }
    /// At rest or hidden, the view takes no time at all.
    void viewTicksOnlyWhileItIsShownAndSomethingMoves() {
        test::Stage stage;
        ViewportWidget viewport;
        PlayView view(stage.controller, viewport);
        viewport.show();
        QVERIFY(QTest::qWaitForWindowExposed(&viewport, kPatience));
        QVERIFY(!view.isTicking());
        stage.start();
        QVERIFY(view.isTicking());
        viewport.hide();
        QVERIFY(!view.isTicking());
        viewport.show();
        QVERIFY(view.isTicking());
        viewport.setWindowState(Qt::WindowMinimized);
        QVERIFY(!view.isTicking());
        viewport.setWindowState(Qt::WindowNoState);
        QVERIFY(view.isTicking());
        stage.controller.pause();
        view.refresh();
        QVERIFY(!view.isTicking());
        stage.controller.play();
        QVERIFY(view.isTicking());
        stage.advance(200);
        view.refresh();
        QVERIFY(!view.isTicking());
        QVERIFY2(view.hud().accessibleText().contains("at rest"), qPrintable(view.hud().accessibleText()));
        stage.controller.setToolSettings(test::heavyBox());
        stage.controller.throwAlong(test::kAtBlock);
        stage.settle();
        stage.advance(1);
        QVERIFY(view.isTicking());
    }
    void textsSayWhatWouldFall() {
        test::Stage stage(test::stackProject());
        ViewportWidget viewport;
        PlayView view(stage.controller, viewport);
        stage.start();
        stage.controller.setOverlays({.hasCollapse = true});
        const auto textAt = [&](double height) {
            stage.controller.aim(Ray{{0.0, height, 4.0}, {0.0, 0.0, -1.0}});
            stage.advance(30);
            view.refresh();
            return view.hud().accessibleText();
        };
        const QString lowest = textAt(0.25), highest = textAt(2.25);
        QVERIFY2(lowest.contains("Without block 0, 4 bodies would fall: 2000\u00a0kg, for up to 0.6"),
                 qPrintable(lowest));
        QVERIFY2(highest.contains("Without block 4, nothing would fall"), qPrintable(highest));
    }
    void grabShowsItsSpringAndWhetherItCanLift() {
        Project project = test::floatingBlock();
        project.gravity = Vec3(0.0, -9.81, 0.0);
        test::Stage stage(project);
        ViewportWidget viewport;
        viewport.resize(640, 480);
        PlayView view(stage.controller, viewport);
        viewport.setOverlayItems({&view.hud()});
        stage.start();
        for (const auto& [force, text] : {std::pair(2e4, "500\u00a0kg"), std::pair(2e3, "Too heavy to lift")}) {
            PlayToolSettings tools;
            tools.grabForce = force;
            stage.controller.setToolSettings(tools);
            stage.advance(1);
            view.refresh();
            viewport.frameAll();
            stage.controller.grabAlong(test::kAtBlock);
            stage.controller.dragAlong({test::kAtBlock.from + Vec3(1.0, 0.0, 0.0), test::kAtBlock.direction});
            stage.advance(1);
            view.refresh();
            QVERIFY2(view.hud().accessibleText().contains(text), qPrintable(view.hud().accessibleText()));
            const QImage with = viewport.grab().toImage();
            stage.controller.release();
            stage.advance(1);
            view.refresh();
            QVERIFY(!view.hud().accessibleText().contains(text));
            QVERIFY(viewport.grab().toImage() != with);
        }
    }
    /// The clock runs since the program was started.
    void firstFrameRateIsThatOfPlay() {
        test::Stage stage;
        stage.advance(600);
        ViewportWidget viewport;
        PlayView view(stage.controller, viewport);
        view.setStatisticsShown(true);
        for (int round = 0; round < 2; ++round) {
            for (int k = 0; k < 500; ++k) emit viewport.drawn();  // before it starts
            stage.start();
            view.refresh();
            QVERIFY2(view.hud().accessibleText().contains("– fps"), qPrintable(view.hud().accessibleText()));
            for (int k = 0; k < 30; ++k) emit viewport.drawn();
            stage.advance(60);
            view.refresh();
            QVERIFY2(view.hud().accessibleText().contains(" 30 fps"), qPrintable(view.hud().accessibleText()));
            stage.controller.stop();
            stage.settle();
            stage.advance(120);
        }
    }
    void statisticsAreHiddenAtFirst() {
        test::Stage stage;
        ViewportWidget viewport;
        PlayView view(stage.controller, viewport);
        stage.start();
        view.refresh();
        QVERIFY(view.hud().accessibleText().contains("Playing"));
        QVERIFY(!view.hud().accessibleText().contains("bodies"));
        view.setStatisticsShown(true);
        QVERIFY(view.hud().accessibleText().contains("bodies"));
    }
    void controlAndWheelChangeTheBlastRadius() {
        test::Stage stage;
        ViewportWidget viewport;
        PlayView view(stage.controller, viewport);
        const auto turn = [&](int notches, Qt::KeyboardModifiers modifiers) {
            const QWheelEvent event({}, {}, {}, {0, 120 * notches}, Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
            return view.tool().wheel(event);
        };
        QVERIFY(!turn(1, Qt::ControlModifier));  // nothing is simulated
        stage.start();
        QVERIFY(!turn(1, {}));  // zooms
        const double before = stage.controller.toolSettings().blast.radius;
        QVERIFY(turn(2, Qt::ControlModifier));
        QCOMPARE(stage.controller.toolSettings().blast.radius, before * 1.1 * 1.1);
        QVERIFY(turn(-10000, Qt::ControlModifier));
        QVERIFY(turn(1, Qt::ControlModifier));
        QCOMPARE(stage.controller.toolSettings().blast.radius, 0.011);
    }
};

RUBBLE_TEST_WITH(PlayViewTest, QApplication)
#include "PlayViewTest.moc"
