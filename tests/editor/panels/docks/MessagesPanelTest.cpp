#include "editor/panels/docks/MessagesPanel.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeView>

using namespace rubble;

class MessagesPanelTest : public QObject {
    Q_OBJECT
private slots:
    void filtersCountAndHideBySeverity() {
        Desk desk;
        QCOMPARE(desk.view().model()->rowCount(), 3);
        QCOMPARE(desk.button("Show notes").text(), "1");
        QCOMPARE(desk.button("Show warnings").text(), "2");
        desk.button("Show warnings").click();
        QCOMPARE(desk.view().model()->rowCount(), 1);
        desk.button("Show warnings").click();
        QCOMPARE(desk.view().model()->rowCount(), 3);
    }
    void onlyMessagesWithAPlaceJump() {
        Desk desk;
        const QSignalSpy jumps(&desk.panel, &MessagesPanel::jumpRequested);
        emit desk.view().activated(desk.view().model()->index(0, 0));
        QCOMPARE(jumps.count(), 0);
        emit desk.view().activated(desk.view().model()->index(1, 0));
        QCOMPARE(jumps.count(), 1);
    }
    void selectedTextsAreCopied() {
        Desk desk;
        desk.view().selectAll();
        for (QAction* action : desk.view().actions()) action->trigger();
        QCOMPARE(QGuiApplication::clipboard()->text(), "Read.\nA sliver.\nA gap.");
    }
    void clearRemovesAll() {
        Desk desk;
        desk.button("Clear").click();
        QVERIFY(desk.messages.list().empty());
        QCOMPARE(desk.button("Show warnings").text(), "0");
    }

private:
    struct Desk {
        Document document{boxProject(UniformScatter{.count = 4})};
        Messages messages;
        MessagesPanel panel{messages, document};

        Desk() {
            messages.add({.severity = Severity::Note, .text = "Read."});
            messages.add({.severity = Severity::Warning, .text = "A sliver.", .asset = 2});
            messages.add({.severity = Severity::Warning, .text = "A gap.", .asset = 2});
        }
        QTreeView& view() { return *panel.findChild<QTreeView*>(); }
        QToolButton& button(const QString& name) {
            for (QToolButton* button : panel.findChildren<QToolButton*>()) {
                if (button->accessibleName() == name) return *button;
            }
            qFatal("There is no button \"%s\".", qPrintable(name));
        }
    };
};

RUBBLE_TEST_WITH(MessagesPanelTest, QApplication)
#include "MessagesPanelTest.moc"
