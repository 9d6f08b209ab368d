// Tests editor/window/StartPage.cpp and what its demo starts.
#include "editor/document/Bakes.h"
#include "editor/widgets/ColourScheme.h"
#include "editor/workspace/InstalledData.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/EditorStory.h"
#include "tests/support/editor/TextFit.h"

#include <QCommandLinkButton>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QToolButton>

using namespace rubble;

/// The demo house plays with one click or one key, and a click in the view breaks it.
class StartPageTest : public EditorStory {
    Q_OBJECT
private slots:
    void cleanup() { close(); }

    void oneClickPlaysTheDemoHouse() {
        openStartPage();
        if (!hasView()) QSKIP("There is no OpenGL here.");
        play().thread().useSteppedClock();
        QTest::mouseClick(demo(), Qt::LeftButton);
        playsDemo();
        const QPoint middle = viewport().rect().center();
        QTest::mouseMove(&viewport(), middle);
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, middle);
        QTRY_VERIFY_WITH_TIMEOUT(breaksAfterAStep(), kPatience);
        QVERIFY(!window().isWindowModified());
        QCOMPARE(window().workspace().file().path(), QString());  // a copy
    }
    void returnPlaysTheDemoHouse() {
        openStartPage();
        QCOMPARE(demo()->accessibleName(), "Play the Demo House");
        QVERIFY(!demo()->accessibleDescription().isEmpty());
        QVERIFY(!demo()->toolTip().isEmpty());
        for (int k = 0; k < 20 && !demo()->hasFocus(); ++k) QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QVERIFY(demo()->hasFocus());
        QTest::keyClick(demo(), Qt::Key_Return);
        playsDemo();
    }
    void returnOpensTheExampleWithTheFocus() {
        openStartPage();
        QToolButton* card = nullptr;
        for (auto* one : window().centralWidget()->findChildren<QToolButton*>()) {
            if (one->toolTip() == "Open a copy of this example") card = one;
        }
        QVERIFY(card);
        card->setFocus();
        QTest::keyClick(card, Qt::Key_Return);
        QTRY_VERIFY(!window().isPristine());
    }
    void menuOpensCopiesOfAllExamples() {
        openStartPage();
        const auto* examples = window().findChild<QMenu*>("file-examples");
        QVERIFY(examples);
        const QList<QAction*> actions = examples->actions();
        QCOMPARE(actions.size(), exampleProjects().size());
        const auto wall = std::ranges::find(actions, QString("Wall with openings"), &QAction::text);
        QVERIFY(wall != actions.end());
        (*wall)->trigger();
        QTRY_VERIFY(!window().isPristine());
        QCOMPARE(text(), projectText(*loadProject(RUBBLE_SOURCE_DIR "/projects/wall-with-openings.rubble")));
        QCOMPARE(window().workspace().file().path(), QString());
    }
    /// What is opened from a start page takes its place, but not that of a project which was saved there.
    void savedProjectIsNotReplaced() {
        openStartPage();
        QTemporaryDir folder;
        const QString path = folder.filePath("saved.rubble");
        test::onNextDialog<QFileDialog>([path](QFileDialog& dialog) { test::acceptFile(dialog, path); });
        window().findChild<QAction*>("file-save-as")->trigger();
        QCOMPARE(window().workspace().file().path(), path);
        QVERIFY(!window().isPristine() && !window().isUntouched());
        const std::string saved = text();
        emit window().openCopyRequested(RUBBLE_SOURCE_DIR "/projects/house.rubble");
        QCOMPARE(text(), saved);
        QCOMPARE(window().workspace().file().path(), path);
        const QWidgetList widgets = QApplication::topLevelWidgets();
        const auto isOther = [&](QWidget* one) { return qobject_cast<MainWindow*>(one) && one != &window(); };
        const auto opened = std::ranges::find_if(widgets, isOther);
        QVERIFY(opened != widgets.end());
        delete *opened;
    }
    void clickSelectsInOtherSimulations() {
        openStartPage();
        QVERIFY(!play().toolSettings().throwsOnClick);
    }
    void fitsOnASmallScreen_data() {
        QTest::addColumn<int>("theme");
        QTest::newRow("light") << static_cast<int>(ColourScheme::Light);
        QTest::newRow("dark") << static_cast<int>(ColourScheme::Dark);
    }
    void fitsOnASmallScreen() {
        QFETCH(const int, theme);
        openStartPage();
        preferences().setPreferences({.theme = static_cast<ColourScheme>(theme)});
        QTRY_COMPARE(isDark(window().palette()), theme == static_cast<int>(ColourScheme::Dark));
        window().resize(1280, 720);
        QTRY_COMPARE_WITH_TIMEOUT(window().size(), QSize(1280, 720), kPatience);
        auto* page = window().centralWidget()->findChild<QScrollArea*>();
        QTRY_VERIFY(page->verticalScrollBar()->maximum() == 0 && page->horizontalScrollBar()->maximum() == 0);
        const QString folder = qEnvironmentVariable("RUBBLE_PICTURES");  // for inspection by a person
        if (!folder.isEmpty()) window().grab().save(QString("%1/start-%2.png").arg(folder, QTest::currentDataTag()));
        const QStringList faults = test::clippedTexts(*page) + test::faintTexts(*page);
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
    }

private:
    PlayController& play() { return window().workspace().play(); }
    QCommandLinkButton* demo() { return window().findChild<QCommandLinkButton*>("play-demo"); }
    void playsDemo() {
        QVERIFY(!window().isPristine());
        QVERIFY(play().isInPlay());
        QVERIFY(play().toolSettings().throwsOnClick);
        QTRY_VERIFY_WITH_TIMEOUT(play().isPlaying(), kPatience);
        QCOMPARE(text(), projectText(*loadProject(RUBBLE_SOURCE_DIR "/projects/house.rubble")));
    }
    bool breaksAfterAStep() {
        play().thread().advance(kStep);
        play().applyUpdate();
        return !play().events().breaks().empty();
    }
};

RUBBLE_TEST_WITH(StartPageTest, QApplication)
#include "StartPageTest.moc"
