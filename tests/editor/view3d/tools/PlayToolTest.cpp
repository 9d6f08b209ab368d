// Also of editor/widgets/input/HeldKey.cpp, which needs X11: the tests of editor/widgets do without.
#include "editor/view3d/tools/PlayTool.h"

#include "editor/widgets/input/HeldKey.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/PlayStage.h"
#include "viewport/widget/ViewportWidget.h"

#include <QApplication>
#include <QKeyEvent>
#include <QProcess>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QWheelEvent>

using namespace rubble;

class PlayToolTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_stage = std::make_unique<test::Stage>();
        m_viewport = std::make_unique<ViewportWidget>();
        m_viewport->resize(640, 480);
        m_tool = std::make_unique<PlayTool>(m_stage->controller, *m_viewport);
    }
    void cleanup() {
        m_tool.reset();
        m_viewport.reset();
        m_stage.reset();
    }
    void keysAreItsOwnInPlayOnly() {
        QVERIFY(!m_tool->overridesShortcut(key(Qt::Key_F)));
        QVERIFY(!m_tool->keyPress(key(Qt::Key_H)));
        m_stage->start();
        for (const Qt::Key own : {Qt::Key_F, Qt::Key_H, Qt::Key_X, Qt::Key_Escape})
            QVERIFY(m_tool->overridesShortcut(key(own)));
        QVERIFY(!m_tool->overridesShortcut(key(Qt::Key_H, Qt::AltModifier)));
        QVERIFY(!m_tool->overridesShortcut(key(Qt::Key_G)));
    }
    void heldKeyChargesTheThrow() {
        m_stage->start();
        m_tool->enter({320.0, 240.0});
        m_tool->keyPress(key(Qt::Key_F));
        QCOMPARE(m_tool->charge(), std::optional(0.0));
        m_stage->advance(36);  // 0.6 s: half way from a tap to the full charge
        QVERIFY(std::abs(*m_tool->charge() - 0.5) < 1e-9);
        m_stage->advance(60);
        QCOMPARE(m_tool->charge(), std::optional(1.0));
        QVERIFY(!m_stage->controller.lastShot());
        m_tool->keyRelease({QEvent::KeyRelease, Qt::Key_F, {}});
        m_stage->advance(1);
        QVERIFY(m_stage->controller.lastShot());
        QVERIFY(!m_tool->charge());
    }
    /// As X11 reports it for a held key, if Qt does not recognize the repetition.
    void anotherPressDoesNotRestartTheCharge() {
        m_stage->start();
        m_tool->enter({320.0, 240.0});
        m_tool->keyPress(key(Qt::Key_F));
        m_stage->advance(36);
        m_tool->keyPress(key(Qt::Key_F));
        QVERIFY(std::abs(*m_tool->charge() - 0.5) < 1e-9);
    }
    void releaseOfAHeldKeyDoesNotThrow() {
        const QString keyboard = QStandardPaths::findExecutable("xdotool");
        if (keyboard.isEmpty()) QSKIP("xdotool is not installed");
        QCOMPARE(heldKeys(), std::vector<quint32>());
        QCOMPARE(QProcess::execute(keyboard, {"keydown", "f"}), 0);
        const std::vector<quint32> held = heldKeys();
        QCOMPARE(held.size(), 1u);
        m_stage->start();
        m_tool->enter({320.0, 240.0});
        m_tool->keyPress(key(Qt::Key_F));
        m_tool->keyRelease(release(held.front()));
        m_stage->advance(1);
        QVERIFY(!m_stage->controller.lastShot() && m_tool->charge());
        QCOMPARE(QProcess::execute(keyboard, {"keyup", "f"}), 0);
        QCOMPARE(heldKeys(), std::vector<quint32>());
        m_tool->keyRelease(release(held.front()));
        m_stage->advance(1);
        QVERIFY(m_stage->controller.lastShot() && !m_tool->charge());
    }
    void escapeCancelsTheChargeBeforeItStops() {
        m_stage->start();
        m_tool->enter({320.0, 240.0});
        m_tool->keyPress(key(Qt::Key_F));
        QVERIFY(m_tool->keyPress(key(Qt::Key_Escape)));
        QVERIFY(!m_tool->charge() && m_stage->controller.isInPlay());
        QVERIFY(m_tool->keyPress(key(Qt::Key_Escape)));
        QVERIFY(!m_stage->controller.isInPlay());
    }
    void chargeEndsWithTheFocus() {
        m_stage->start();
        m_tool->enter({320.0, 240.0});
        m_tool->keyPress(key(Qt::Key_F));
        m_tool->focusLost();
        QVERIFY(!m_tool->charge());
    }
    /// Outside of play, R rotates instances; in play it resets, or does nothing while that is disabled.
    void keysOfTheActionsAreTakenInPlay() {
        QAction reset;
        reset.setShortcut(QKeySequence("R"));
        reset.setAutoRepeat(false);
        const QSignalSpy triggered(&reset, &QAction::triggered);
        m_tool->setActions({&reset});
        QVERIFY(!m_tool->overridesShortcut(key(Qt::Key_R)));
        m_stage->start();
        QVERIFY(m_tool->overridesShortcut(key(Qt::Key_R)));
        QVERIFY(m_tool->keyPress(key(Qt::Key_R)));
        QCOMPARE(triggered.count(), 1);
        QVERIFY(m_tool->keyPress({QEvent::KeyPress, Qt::Key_R, {}, {}, true}));
        QCOMPARE(triggered.count(), 1);
        reset.setEnabled(false);
        QVERIFY(m_tool->keyPress(key(Qt::Key_R)));
        QCOMPARE(triggered.count(), 1);
    }
    void controlAndWheelChangeTheRadiusOfTheBlast() {
        m_stage->start();
        const double before = m_stage->controller.toolSettings().blast.radius;
        const QSignalSpy messages(m_tool.get(), &PlayTool::statusMessage);
        QVERIFY(!m_tool->wheel(wheel(Qt::NoModifier)));
        QVERIFY(m_tool->wheel(wheel(Qt::ControlModifier)));
        QVERIFY(std::abs(m_stage->controller.toolSettings().blast.radius - 1.1 * before) < 1e-12);
        QCOMPARE(messages.count(), 1);
    }
    void clickThrowsIfThatIsSet() {
        m_stage->start();
        m_tool->press(mouse(QEvent::MouseButtonPress));
        QVERIFY(!m_tool->release(mouse(QEvent::MouseButtonRelease)));
        PlayToolSettings tools = m_stage->controller.toolSettings();
        tools.throwsOnClick = true;
        m_stage->controller.setToolSettings(tools);
        m_tool->press(mouse(QEvent::MouseButtonPress));
        QVERIFY(m_tool->release(mouse(QEvent::MouseButtonRelease)));
        m_stage->advance(1);
        QVERIFY(m_stage->controller.lastShot());
    }

private:
    static QKeyEvent release(quint32 scanCode) {
        return {QEvent::KeyRelease, Qt::Key_F, Qt::NoModifier, scanCode, 0, 0};
    }
    static std::vector<quint32> heldKeys() {
        std::vector<quint32> held;
        for (quint32 code = 0; code < 256; ++code)
            if (isHeld(release(code))) held.push_back(code);
        return held;
    }
    static QKeyEvent key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        return {QEvent::KeyPress, key, modifiers};
    }
    static QWheelEvent wheel(Qt::KeyboardModifiers modifiers) {
        return {{}, {}, {}, {0, 120}, Qt::NoButton, modifiers, Qt::NoScrollPhase, false};
    }
    static QMouseEvent mouse(QEvent::Type type) {
        const QPointF middle(320.0, 240.0);
        return {type, middle, middle, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier};
    }

    std::unique_ptr<test::Stage> m_stage;
    std::unique_ptr<ViewportWidget> m_viewport;
    std::unique_ptr<PlayTool> m_tool;
};

RUBBLE_TEST_WITH(PlayToolTest, QApplication)
#include "PlayToolTest.moc"
