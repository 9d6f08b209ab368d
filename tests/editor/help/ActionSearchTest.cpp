#include "editor/help/ActionSearch.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/EventLoop.h"

#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QTest>

using namespace rubble;

class ActionSearchTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        add(m_edit, "Re&store Seeds", "Restore the scattered seeds");
        add(m_edit, "&Escape", "Leave");
        add(m_asset, "Du&plicate Asset", "Duplicate the asset");
        add(m_asset, "Grid &Scale…", "Wider or narrower");
        add(m_asset, "Scatter A&gain", "Set a new random seed");
    }
    void namesMatchBeforeTips() {
        QCOMPARE(found("sca"), QStringList({"Scatter A&gain", "Grid &Scale…", "&Escape", "Re&store Seeds"}));
    }
    void allWordsMustMatch() {
        QCOMPARE(found("seed again"), QStringList({"Scatter A&gain"}));
        QCOMPARE(found("asset  DUP"), QStringList({"Du&plicate Asset"}));
        QCOMPARE(found("again never"), QStringList());
    }
    void menuNamesMatch() {
        QCOMPARE(found("edit"), QStringList({"Re&store Seeds", "&Escape"}));
        QCOMPARE(found("asset")[0], "Du&plicate Asset");
    }
    void synonymsMatchLast() {
        add(m_asset, "&Blast", "Set off a blast");
        add(m_asset, "Screen&shot of Seeds", "Save a file");
        QCOMPARE(found("expl"), QStringList({"&Blast"}));
        QCOMPARE(found("bomb"), QStringList({"&Blast"}));
        QCOMPARE(found("picture"), QStringList({"Screen&shot of Seeds"}));
        for (int k = 0; k < 2; ++k) delete m_actions.takeLast();
    }
    void unmatchedQueryIsReported() {
        QWidget window;
        ActionSearch search({m_actions.front()}, &window);
        search.show();
        auto* query = search.findChild<QLineEdit*>();
        auto* list = search.findChild<QListWidget*>();
        query->setText("xyz");
        QCOMPARE(list->count(), 1);
        QCOMPARE(list->item(0)->text(), QString("No action matches \"xyz\". Try another word."));
        QTest::keyClick(query, Qt::Key_Return);
        QVERIFY(search.isVisible());
    }
    void emptyQueryMatchesAllActions() { QCOMPARE(found("").size(), 5); }
    void disabledActionsComeLastAndAreNotTriggered() {
        QAction* last = m_actions.back();
        last->setEnabled(false);
        QCOMPARE(found("sca").last(), "Scatter A&gain");
        QWidget window;
        ActionSearch search({last}, &window);
        bool isTriggered = false;
        connect(last, &QAction::triggered, &search, [&] { isTriggered = true; });
        search.show();
        QTest::keyClick(search.findChild<QLineEdit*>(), Qt::Key_Return);
        test::runTimersDueWithin(10);
        QVERIFY(search.isVisible() && !isTriggered);
        QVERIFY(search.findChild<QListWidget*>()->item(0)->text().contains("not available now"));
        last->setEnabled(true);
    }
    void commandsComeBeforeEntriesOfSubmenus() {
        QMenu view("&View"), play("&Play");
        QMenu* docks = view.addMenu("&Docks");
        QAction* dock = docks->addAction("Play");
        QAction* start = play.addAction("&Play");
        QCOMPARE(matchingActions("pla", {dock, start}), (QList<QAction*>{start, dock}));
    }
    void actionsMayBeRemovedMeanwhile() {
        QWidget window;
        QMenu recent("Recent");
        QAction* project = recent.addAction("wall.rubble");
        ActionSearch search({project, m_actions.front()}, &window);
        auto* query = search.findChild<QLineEdit*>();
        auto* list = search.findChild<QListWidget*>();
        QCOMPARE(list->count(), 2);
        delete project;
        QTest::keyClick(query, Qt::Key_Return);  // on the row of the removed action
        QVERIFY(!search.isVisible());
        query->setText("r");
        QCOMPARE(list->count(), 1);
    }

private:
    void add(QMenu& menu, const QString& text, const QString& tip) {
        m_actions.append(menu.addAction(text));
        m_actions.back()->setStatusTip(tip);
    }
    QStringList found(const QString& query) const {
        QStringList texts;
        for (const QAction* action : matchingActions(query, m_actions)) texts.append(action->text());
        return texts;
    }

    QMenu m_edit{"&Edit"}, m_asset{"&Asset"};
    QList<QAction*> m_actions;
};

RUBBLE_TEST_WITH(ActionSearchTest, QApplication)
#include "ActionSearchTest.moc"
