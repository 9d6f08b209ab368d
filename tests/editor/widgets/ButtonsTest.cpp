// Tests editor/widgets/Buttons.cpp and editor/widgets/Icon.cpp.
#include "editor/widgets/Buttons.h"

#include "editor/widgets/Action.h"
#include "tests/support/TestProgram.h"

#include <QApplication>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>

using namespace rubble;

class ButtonsTest : public QObject {
    Q_OBJECT
private slots:
    void buttonHasNameAndHintForEverybody() {
        QWidget panel;
        const QToolButton* button = panelButton("add", "Add Point", "Add a point", &panel);
        QVERIFY(!button->icon().isNull() && button->autoRaise());
        QCOMPARE(button->accessibleName(), "Add Point");
        QCOMPARE(button->toolTip(), "Add a point");
        QCOMPARE(button->statusTip(), "Add a point");
        QVERIFY(button->focusPolicy() & Qt::TabFocus);
    }
    void buttonWithoutIconShowsItsText() {
        QWidget panel;
        const QToolButton* button = panelButton({}, "Cancel", "Cancel the task", &panel);
        QVERIFY(button->icon().isNull());
        QCOMPARE(button->text(), "Cancel");
    }
    void buttonFollowsItsAction() {
        QWidget panel;
        auto* action = makeAction(&panel, {"hide", "&Hide", "Hide the selection"});
        const QToolButton* button = panelButton(action, &panel);
        QCOMPARE(button->accessibleName(), "Hide");
        action->setEnabled(false);
        QVERIFY(!button->isEnabled());
    }
    void menuActionCallsItsFunction() {
        QMenu menu;
        int called = 0;
        QAction* action = menuAction(menu, "add", "Add", "Add a layer", [&] { ++called; });
        QCOMPARE(action->statusTip(), "Add a layer");
        action->trigger();
        QCOMPARE(called, 1);
    }
    void clearButtonHasAName() {
        QLineEdit line;
        addClearButton(line);
        QCOMPARE(line.findChild<QToolButton*>()->accessibleName(), "Clear");
    }
    void iconsAreDrawnInTheColourOfTheText() {
        const QIcon icon = iconNamed("add");
        const QImage enabled = icon.pixmap(24).toImage(), disabled = icon.pixmap(24, QIcon::Disabled).toImage();
        QVERIFY(!enabled.isNull() && enabled != disabled);
        QVERIFY(iconNamed("no such icon").isNull());
    }
};

RUBBLE_TEST_WITH(ButtonsTest, QApplication)
#include "ButtonsTest.moc"
