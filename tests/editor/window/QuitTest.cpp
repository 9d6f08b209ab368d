// Tests Program::quit() and which windows are used again, in editor/window/Program.cpp.
#include "core/asset/library/StarterProject.h"
#include "core/io/project/ProjectFile.h"
#include "editor/actions/FileActions.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/document/FilePath.h"
#include "editor/views/Views.h"
#include "editor/window/MainWindow.h"
#include "editor/window/Program.h"
#include "tests/support/Patience.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/TestSettings.h"
#include "tests/support/editor/Windows.h"

#include <QMessageBox>
#include <QScreen>
#include <QStandardPaths>
#include <QTemporaryDir>

using namespace rubble;

class QuitTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        test::keepSettingsIn(m_folder.path());
        QApplication::setQuitOnLastWindowClosed(false);
    }
    void init() { m_program = std::make_unique<Program>(); }
    void cleanup() {
        for (MainWindow* window : test::windows()) delete window;
        m_program.reset();
    }

    void untouchedWindowIsUsedAgain() {
        MainWindow* window = m_program->showStartPage();
        trigger(*window, "file-new");
        QVERIFY(!window->isPristine() && window->isUntouched());
        trigger(*window, "file-new");
        QCOMPARE(test::windows().size(), 1);
        QVERIFY(m_program->open(savedProject(), window) == window);
        QVERIFY(!window->isUntouched());
        trigger(*window, "file-new");
        QCOMPARE(test::windows().size(), 2);
    }
    void editedWindowIsKept() {
        MainWindow* window = edited();
        trigger(*window, "file-new");
        QCOMPARE(test::windows().size(), 2);
        QVERIFY(window->workspace().document().isModified());
    }
    void oneQuestionForAllWindows_data() {
        QTest::addColumn<QString>("answer");
        QTest::addColumn<int>("left");
        QTest::newRow("discard") << "Discard All" << 0;
        QTest::newRow("cancel") << "Cancel" << 3;
    }
    void oneQuestionForAllWindows() {
        QFETCH(const QString, answer);
        QFETCH(const int, left);
        for (int k = 0; k < 3; ++k) edited();
        QString question;
        test::onNextDialog<QMessageBox>([&](QMessageBox& box) {
            question = box.text();
            press(box, answer);
        });
        m_program->quit();
        QCOMPARE(question.count("Untitled"), 3);
        QCOMPARE(shownWindows(), left);
    }
    void cancelledQuitClosesNoWindow() {
        for (int k = 0; k < 2; ++k) QVERIFY(m_program->open(savedProject(), nullptr));
        edited();
        test::onNextDialog<QMessageBox>([](QMessageBox& box) { QTest::keyClick(&box, Qt::Key_Escape); });
        m_program->quit();
        QCOMPARE(shownWindows(), 3);
        test::onNextDialog<QMessageBox>([](QMessageBox& box) { press(box, "Discard"); });
        m_program->quit();
        QCOMPARE(shownWindows(), 0);
    }
    void answersForEachCloseAllTogether() {
        for (int k = 0; k < 2; ++k) edited();
        test::onNextDialog<QMessageBox>([](QMessageBox& box) {
            test::onNextDialog<QMessageBox>([](QMessageBox& first) {
                test::onNextDialog<QMessageBox>([](QMessageBox& second) { press(second, "Cancel"); });
                press(first, "Discard");
            });
            press(box, "Ask for Each");
        });
        m_program->quit();
        QCOMPARE(shownWindows(), 2);
    }
    void windowsAreCascaded() {
        const MainWindow* first = m_program->open(savedProject(), nullptr);
        const MainWindow* second = m_program->open(savedProject(), nullptr);
        const QPoint offset = second->pos() - first->pos();
        QVERIFY2(offset.y() >= 15, qPrintable(QString::number(offset.y())));  // the screen may be as narrow as a window
        QVERIFY(second->screen()->availableGeometry().contains(second->geometry()));
    }
    void saveAllSavesFilesInPlace() {
        const QString first = savedProject(), second = savedProject();
        for (const QString& path : {first, second}) edit(*m_program->open(path, nullptr));
        test::onNextDialog<QMessageBox>([](QMessageBox& box) { box.defaultButton()->click(); });
        m_program->quit();
        QCOMPARE(shownWindows(), 0);
        for (const QString& path : {first, second}) {
            const Result<Project> project = loadProject(toPath(path));
            QVERIFY(project && project->ground.height == kHeight);
        }
    }

private:
    static constexpr double kHeight = 4.0;  // m, of the ground in edited projects

    QString savedProject() {
        const QString path = m_folder.filePath(QString("project-%1.rubble").arg(m_saved++));
        if (!saveProject(toPath(path), starterProject())) qFatal("not saved");
        return path;
    }
    static void press(QMessageBox& box, const QString& answer) {
        for (QAbstractButton* button : box.buttons()) {
            if (button->text().remove('&') == answer) return button->click();
        }
    }
    static void edit(MainWindow& window) {
        Document& document = window.workspace().document();
        SceneSettings scene = sceneSettings(document.project());
        scene.ground.height = kHeight;
        document.push(modify("Raise Ground", scene));
    }
    MainWindow* edited() {
        MainWindow* window = m_program->showProject(starterProject());
        edit(*window);
        return window;
    }
    static void trigger(MainWindow& window, const char* name) { window.findChild<QAction*>(name)->trigger(); }
    static int shownWindows() {
        return static_cast<int>(std::ranges::count_if(test::windows(), &MainWindow::isVisible));
    }

    QTemporaryDir m_folder;
    int m_saved = 0;
    std::unique_ptr<Program> m_program;
};

RUBBLE_TEST_WITH(QuitTest, QApplication)
#include "QuitTest.moc"
