#include "editor/view3d/tools/ActionKeys.h"

#include "tests/support/TestProgram.h"

#include <QGuiApplication>
#include <QKeyEvent>

using namespace rubble;

class ActionKeysTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_triggered = 0;
        m_action = std::make_unique<QAction>();
        m_action->setShortcut(QKeySequence("Alt+H"));
        connect(m_action.get(), &QAction::triggered, this, [this] { ++m_triggered; });
        m_keys.setActions({m_action.get()});
    }
    void shortcutTriggersTheActionOnItsPress() {
        QVERIFY(m_keys.overridesShortcut(override(Qt::AltModifier)));
        QCOMPARE(m_triggered, 0);
        QVERIFY(m_keys.keyPress(press(Qt::AltModifier)));
        QCOMPARE(m_triggered, 1);
    }
    void otherKeysAreLeft() {
        QVERIFY(!m_keys.overridesShortcut(override(Qt::NoModifier)));
        QVERIFY(!m_keys.keyPress(press(Qt::NoModifier)));
        QCOMPARE(m_triggered, 0);
    }
    void disabledActionLeavesItsKey() {
        m_action->setEnabled(false);
        QVERIFY(!m_keys.overridesShortcut(override(Qt::AltModifier)));
        QVERIFY(!m_keys.keyPress(press(Qt::AltModifier)));
    }

private:
    static QKeyEvent override(Qt::KeyboardModifiers modifiers) {
        return {QEvent::ShortcutOverride, Qt::Key_H, modifiers};
    }
    static QKeyEvent press(Qt::KeyboardModifiers modifiers) { return {QEvent::KeyPress, Qt::Key_H, modifiers}; }

    std::unique_ptr<QAction> m_action;
    ActionKeys m_keys;
    int m_triggered = 0;
};

RUBBLE_TEST_WITH(ActionKeysTest, QGuiApplication)
#include "ActionKeysTest.moc"
