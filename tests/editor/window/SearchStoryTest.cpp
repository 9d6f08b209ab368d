// Tests editor/help/ActionSearch.cpp with all actions of the window.
#include "core/asset/library/StarterProject.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/help/ActionSearch.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/EditorStory.h"

#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>

using namespace rubble;

class SearchStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        openBaked(starterProject());
        for (const QAction* menu : window().menuBar()->actions()) collect(*menu->menu());
        QVERIFY(m_actions.size() > 100);
    }
    void cleanupTestCase() { close(); }

    void everyWordFindsItsAction() {
        for (QAction* action : m_actions) {
            const QString texts = rubble::pathOf(action) + ' ' + action->statusTip() + ' ' + action->toolTip();
            for (const QString& word : texts.split(QRegularExpression("[^\\w]+"), Qt::SkipEmptyParts)) {
                QVERIFY2(matchingActions(word, m_actions).contains(action),
                         qPrintable(word + " does not find " + rubble::pathOf(action)));
            }
        }
    }
    void wordsOfArtistsFindWhatTheyMean_data() {
        QTest::addColumn<QString>("word");
        QTest::addColumn<QString>("name");
        for (const auto& [word, name] : {std::pair("expl", "play-blast"),
                                         {"blast", "play-blast"},
                                         {"throw", "play-throw"},
                                         {"shoot", "play-throw"},
                                         {"hammer", "play-hammer"},
                                         {"smash", "play-hammer"},
                                         {"settings", "edit-preferences"},
                                         {"help", "help-manual"},
                                         {"simulate", "play-start"}}) {
            QTest::newRow(word) << QString(word) << QString(name);
        }
    }
    void wordsOfArtistsFindWhatTheyMean() {
        QFETCH(const QString, word);
        QFETCH(const QString, name);
        QVERIFY(matchingActions(word, m_actions).contains(action(name.toUtf8())));
    }
    void savedThrowsAreFoundWithoutOpeningTheirMenu() {
        QVERIFY(window().workspace().document().push(addShot(project(), "meteor from above", Throw{}).edit));
        action("help-search")->trigger();
        auto* search = window().findChild<ActionSearch*>();
        QVERIFY(search);
        search->findChild<QLineEdit*>()->setText("meteor");
        QCOMPARE(search->findChild<QListWidget*>()->count(), 1);
        QCOMPARE(search->findChild<QListWidget*>()->item(0)->text(),
                 QString("Play ▸ Repeat Saved Throw ▸ meteor from above"));
        search->close();
    }

private:
    void collect(const QMenu& menu) {
        for (QAction* action : menu.actions()) {
            if (action->menu()) collect(*action->menu());
            if (!action->menu() && !action->isSeparator()) m_actions << action;
        }
    }

    QList<QAction*> m_actions;
};

RUBBLE_TEST_WITH(SearchStoryTest, QApplication)
#include "SearchStoryTest.moc"
