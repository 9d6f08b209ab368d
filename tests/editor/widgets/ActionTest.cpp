#include "editor/widgets/Action.h"

#include "tests/support/TestProgram.h"

#include <QApplication>
#include <QKeyEvent>
#include <QSignalSpy>

using namespace rubble;

class ActionTest : public QObject {
    Q_OBJECT
private slots:
    void toolTipHasNameShortcutAndTip() {
        const auto* action =
            makeAction(this, {"file-open", "&Open…", "Open an existing project", QKeySequence("Ctrl+O")});
        QCOMPARE(action->toolTip(), "Open (Ctrl+O)\nOpen an existing project");
        QCOMPARE(action->statusTip(), "Open an existing project");
        QVERIFY(!action->icon().isNull());
    }
    /// Keys of a view are part of a menu's text, not of a button's.
    void keyAfterTheTabIsNoPartOfTheIconText() {
        QCOMPARE(makeAction(this, {"play-throw", "T&hrow\tF", "Throw"})->iconText(), "Throw");
    }
    void mnemonicsOfGeneratedMenusAreDistinct() {
        QString used = "S";
        QCOMPARE(withMnemonic("Sun", used), "S&un");
        QCOMPARE(withMnemonic("Radial", used), "&Radial");
        QCOMPARE(withMnemonic("Rus", used), "Rus");  // none is left
        QCOMPARE(used, "SuR");
    }
    void keysOfTheKeypadAreThoseOfTheKeyboard() {
        const auto* action = makeAction(this, {"play-step", "Step", "Step", QKeySequence(".")});
        QVERIFY(isShortcutOf(*action, press(Qt::Key_Period)));
        QVERIFY(isShortcutOf(*action, press(Qt::Key_Period, Qt::KeypadModifier)));
        QVERIFY(!isShortcutOf(*action, press(Qt::Key_Period, Qt::ControlModifier)));
        QVERIFY(!isShortcutOf(*action, QKeyEvent(QEvent::KeyRelease, Qt::Key_Period, {})));
    }
    void heldKeyTriggersOnceUnlessTheActionRepeats() {
        auto* action = makeAction(this, {"play-step", "Step", "Step", QKeySequence(".")});
        const QSignalSpy triggered(action, &QAction::triggered);
        const QKeyEvent held(QEvent::KeyPress, Qt::Key_Period, {}, {}, true);
        triggerByKey(*action, held);
        QCOMPARE(triggered.count(), 1);
        action->setAutoRepeat(false);
        triggerByKey(*action, held);
        QCOMPARE(triggered.count(), 1);
        triggerByKey(*action, press(Qt::Key_Period));
        QCOMPARE(triggered.count(), 2);
    }
    void shortcutIsAcceptedBeforeItsPressTriggers() {
        auto* action = makeAction(this, {"hide", "Hide", "Hide", QKeySequence("H")});
        const QSignalSpy triggered(action, &QAction::triggered);
        QKeyEvent override(QEvent::ShortcutOverride, Qt::Key_H, {});
        override.ignore();
        QVERIFY(handleShortcut({action}, override) && override.isAccepted());
        QCOMPARE(triggered.count(), 0);
        QKeyEvent pressed = press(Qt::Key_H);
        QVERIFY(handleShortcut({action}, pressed));
        QCOMPARE(triggered.count(), 1);
        QKeyEvent other = press(Qt::Key_G);
        QVERIFY(!handleShortcut({action}, other));
    }

private:
    static QKeyEvent press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        return {QEvent::KeyPress, key, modifiers};
    }
};

RUBBLE_TEST_WITH(ActionTest, QApplication)
#include "ActionTest.moc"
