// Tests editor/window/Program.cpp, editor/actions/FileActions.cpp, editor/actions/LockQuestion.cpp,
// editor/help/ManualWindow.cpp and editor/actions/HelpActions.cpp.
#include "core/asset/library/StarterProject.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/project/ProjectLock.h"
#include "editor/actions/CompareActions.h"
#include "editor/actions/FileActions.h"
#include "editor/document/FilePath.h"
#include "editor/help/ManualWindow.h"
#include "editor/views/Views.h"
#include "editor/window/MainWindow.h"
#include "editor/window/Program.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/EventLoop.h"
#include "tests/support/editor/TestSettings.h"
#include "tests/support/editor/Windows.h"
#include "tests/support/files/FileLimits.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileSystemWatcher>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMessageBox>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTemporaryDir>

#include <sys/stat.h>

#include <algorithm>
#include <memory>

using namespace rubble;

namespace {

constexpr double kBackupHeight = 3.0;  // m, of the ground in the backup; 0 in the project
constexpr double kEditedHeight = 4.0;
constexpr double kOtherHeight = 5.0;  // in what another program writes

Project projectWithGround(double height) {
    Project project = starterProject();
    project.ground.height = height;
    return project;
}

double heightIn(const QString& path) {
    const Result<Project> project = loadProject(toPath(path));
    return project ? project->ground.height : -1.0;
}

void press(QMessageBox& box, const QString& answer) {
    for (QAbstractButton* button : box.buttons()) {
        if (button->text().remove('&') == answer) return QTest::mouseClick(button, Qt::LeftButton);
    }
    qFatal("There is no answer %s.", qPrintable(answer));
}

/// Enters another path than that of the selected file.
void saveTo(QFileDialog& dialog, const QString& path) {
    dialog.findChild<QListView*>("listView")->clearSelection();
    test::acceptFile(dialog, path);
}

}  // namespace

class RecoveryTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        test::keepSettingsIn(m_settings.path());
        QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        QApplication::setQuitOnLastWindowClosed(false);
    }
    void init() {
        QDir(backupFolder()).removeRecursively();
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath("wall.rubble");
        QVERIFY(saveProject(toPath(m_path), projectWithGround(0.0)));
        m_program = std::make_unique<Program>();
        m_question.clear();
    }
    void cleanup() {
        qDeleteAll(test::windows());
        m_program.reset();
    }

    void backupIsRestoredFromTheStartPage() {
        leaveBackup(m_path);
        answer("Restore");
        m_program->start({});
        QTRY_VERIFY(restored());
        QVERIFY(m_question.contains(m_path));
        QCOMPARE(test::windows().size(), 1);
        QCOMPARE(restored()->workspace().file().path(), m_path);
        QVERIFY(restored()->windowTitle().startsWith("wall.rubble[*] – "));
        QVERIFY(restored()->fileActions().save());
        QCOMPARE(heightIn(m_path), kBackupHeight);
        QVERIFY(backups().isEmpty());
    }
    void backupIsRestoredIntoTheOpenedFile() {
        leaveBackup(m_path);
        answer("Restore");
        m_program->start({m_path});
        QTRY_VERIFY(restored());
        QCOMPARE(test::windows().size(), 1);
        QCOMPARE(restored()->workspace().file().path(), m_path);
        QVERIFY(!restored()->workspace().file().isReadOnly());
        QVERIFY(restored()->fileActions().save());
        QCOMPARE(heightIn(m_path), kBackupHeight);
        QVERIFY(backups().isEmpty());
    }
    void backupIsRestoredWithoutItsFolder() {
        leaveBackup(m_folder->filePath("gone/wall.rubble"));
        answer("Restore");
        m_program->start({});
        QTRY_VERIFY(restored());
        QVERIFY(m_question.contains("no longer exists"));
        QVERIFY(restored()->workspace().file().path().isEmpty());
        const QString elsewhere = m_folder->filePath("elsewhere.rubble");
        test::onNextDialog<QFileDialog>([&](QFileDialog& dialog) { saveTo(dialog, elsewhere); });
        QVERIFY(restored()->fileActions().save());
        QCOMPARE(heightIn(elsewhere), kBackupHeight);
        QVERIFY(backups().isEmpty());
    }
    void backupStaysUntilTheProjectIsSaved() {
        leaveBackup(m_path);
        const QStringList before = backups();
        answer("Restore");
        m_program->start({m_path});
        QTRY_VERIFY(restored());
        QCOMPARE(backups(), before);
        Workspace& workspace = restored()->workspace();
        setHeight(workspace.document(), kEditedHeight);
        {
            const FileSizeLimit fullDisk(10);
            workspace.autosave().writeNow();
        }
        QCOMPARE(backups(), before);
        QCOMPARE(heightIn(before[0]), kBackupHeight);
        workspace.autosave().writeNow();
        QCOMPARE(backups(), before);
        QCOMPARE(heightIn(before[0]), kEditedHeight);
        QVERIFY(restored()->fileActions().save());
        QVERIFY(backups().isEmpty());
    }
    void backupOfAnotherComputerIsTakenOver() {
        leaveBackup(m_path);
        QFile lock(backups()[0].chopped(7) + ".lock");
        QVERIFY(lock.open(QIODevice::WriteOnly));
        lock.write("4711\nrubble\nrender01\nanother machine\nboot\nbob\n");
        lock.close();
        answer("Take Over and Restore");
        m_program->start({});
        QTRY_VERIFY(restored());
        QVERIFY2(m_question.contains("on \"render01\" (user bob, process 4711)"), qPrintable(m_question));
        QVERIFY(restored()->fileActions().save());
        QCOMPARE(heightIn(m_path), kBackupHeight);
        QVERIFY(backups().isEmpty());
    }
    void secondBackupOfOneProjectBecomesACopy() {
        leaveBackup(m_path);
        leaveBackup(m_path);
        test::onNextDialog<QMessageBox>([this](QMessageBox& box) {
            answer("Restore");
            press(box, "Restore");
        });
        m_program->start({m_path});
        QTRY_COMPARE(test::windows().size(), 2);
        QTRY_VERIFY(!QApplication::activeModalWidget());
        QStringList paths;
        for (MainWindow* window : test::windows()) {
            QVERIFY(window->workspace().document().isModified());
            paths.append(window->workspace().file().path());
        }
        paths.sort();
        QCOMPARE(paths, (QStringList{QString(), m_path}));
        QCOMPARE(backups().size(), 2);
    }
    void damagedBackupIsKept() {
        leaveBackup(m_path);
        QFile file(backups()[0]);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("{") == 1);
        file.close();
        test::onNextDialog<QMessageBox>([this](QMessageBox& box) {
            answer("OK");
            press(box, "Restore");
        });
        m_program->start({});
        QTRY_VERIFY(m_question.contains("Cannot read"));
        QCOMPARE(backups().size(), 1);
    }
    void changeAfterTheCrashIsNotOverwrittenUnasked() {
        leaveBackup(m_path);
        QVERIFY(saveProject(toPath(m_path), projectWithGround(kOtherHeight)));
        answer("Restore");
        m_program->start({m_path});
        QTRY_VERIFY(restored());
        answer("Cancel");
        QVERIFY(!restored()->fileActions().save());
        QVERIFY(m_question.contains("changed by another program"));
        QCOMPARE(heightIn(m_path), kOtherHeight);
    }
    void notesOnTheFileAreShown() {
        const QString path = RUBBLE_SOURCE_DIR "/tests/corpus/Project/outlines-with-repeated-points.rubble";
        QVERIFY(QFile::copy(path, m_folder->filePath("repeated.rubble")));
        for (const bool isCopy : {false, true}) {
            MainWindow* window =
                isCopy ? m_program->openCopy(path) : m_program->open(m_folder->filePath("repeated.rubble"));
            QVERIFY(window);
            const std::vector<Message>& messages = window->views().messages().list();
            QCOMPARE(std::ranges::count(messages, "3 repeated points of the outline were left out.", &Message::text),
                     1);
            QCOMPARE(std::ranges::count(messages, "1 repeated point of the outline was left out.", &Message::text), 1);
            QCOMPARE(window->statusBar()->currentMessage(),
                     "\"frame\": 3 repeated points of the outline were left out.");
        }
    }

    void foreignLockIsTakenOverOnRequest() {
        writeForeignLock();
        answer("Take Over Lock");
        MainWindow* window = m_program->open(m_path);
        QVERIFY(window && !window->workspace().file().isReadOnly());
        QVERIFY2(m_question.contains("on \"render01\" (user bob, process 4711)"), qPrintable(m_question));
    }
    void foreignLockGivesAReadOnlyWindow() {
        writeForeignLock();
        answer("Open Read-Only");
        MainWindow* window = m_program->open(m_path);
        QVERIFY(window && window->workspace().file().isReadOnly());
        QVERIFY(window->windowTitle().startsWith("wall.rubble[*] (read-only) – "));
        const auto* label = window->findChild<QLabel*>("read-only");
        QVERIFY(label->isVisible() && label->toolTip().contains("render01"));
        setHeight(window->workspace().document(), kEditedHeight);
        const QString copy = m_folder->filePath("copy.rubble");
        test::onNextDialog<QFileDialog>([&](QFileDialog& dialog) { saveTo(dialog, copy); });
        QVERIFY(window->fileActions().save());
        QCOMPARE(heightIn(m_path), 0.0);
        QCOMPARE(heightIn(copy), kEditedHeight);
        QVERIFY(window->windowTitle().startsWith("copy.rubble[*] – ") && !label->isVisible());
    }
    void readOnlyProjectIsSavedUnderAFreeName() {
        writeForeignLock();
        QVERIFY(QFile::copy(m_path, m_folder->filePath("wall copy.rubble")));
        answer("Open Read-Only");
        MainWindow* window = m_program->open(m_path);
        QVERIFY(window && window->workspace().file().isReadOnly());
        QString offered;
        test::onNextDialog<QFileDialog>([&](QFileDialog& dialog) {
            offered = dialog.findChild<QLineEdit*>("fileNameEdit")->text();
            dialog.reject();
        });
        QVERIFY(!window->fileActions().save());
        QCOMPARE(offered, QString("wall copy 2.rubble"));
    }
    void foreignLockIsTakenOverBySaveAs() {
        writeForeignLock();
        answer("Open Read-Only");
        MainWindow* window = m_program->open(m_path);
        QVERIFY(window && window->workspace().file().isReadOnly());
        setHeight(window->workspace().document(), kEditedHeight);
        test::onNextDialog<QFileDialog>([&](QFileDialog& dialog) {
            test::onNextDialog<QMessageBox>([this](QMessageBox& box) {  // the file exists
                answer("Take Over Lock");
                box.button(QMessageBox::Yes)->click();
            });
            saveTo(dialog, m_path);
        });
        QVERIFY(window->fileActions().save());
        QVERIFY(!window->workspace().file().isReadOnly());
        QCOMPARE(heightIn(m_path), kEditedHeight);
    }
    void cancelledQuestionOpensNothing() {
        writeForeignLock();
        answer("Cancel");
        QVERIFY(!m_program->open(m_path));
        QVERIFY(test::windows().isEmpty());
    }

    void unreadableFileOpensNoWindow() {
        QFile file(m_path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{");
        file.close();
        bool isShownOverWindow = true;
        test::onNextDialog<QMessageBox>([&](QMessageBox& box) {
            isShownOverWindow = !test::windows().isEmpty();
            press(box, "OK");
        });
        QVERIFY(!m_program->open(m_path));
        QVERIFY(!isShownOverWindow && test::windows().isEmpty());
        test::onNextDialog<QMessageBox>([](QMessageBox& box) { press(box, "OK"); });
        QVERIFY(!m_program->openCopy(m_path));
        QVERIFY(test::windows().isEmpty());
    }
    void quittingClosesTheManual() {
        MainWindow* window = m_program->showStartPage();
        window->findChild<QAction*>("help-manual")->trigger();
        const auto isManualOpen = [] {
            return std::ranges::any_of(QApplication::topLevelWidgets(), [](const QWidget* widget) {
                return widget->isVisible() && qobject_cast<const ManualWindow*>(widget);
            });
        };
        QVERIFY(isManualOpen());
        m_program->quit();
        QVERIFY(!isManualOpen());
    }
    void escapeClosesTheManual() {
        ManualWindow manual(RUBBLE_SOURCE_DIR "/docs/manual");
        manual.show();
        QApplication::setActiveWindow(&manual);
        QVERIFY(QTest::qWaitForWindowExposed(&manual));
        auto* field = manual.findChild<QLineEdit*>();
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(!manual.isVisible());
    }
    void oneDialogForAllChangesOnDisk() {
        editedWindow();
        int questions = 0;
        test::onNextDialog<QMessageBox>([&](QMessageBox& box) {
            for (const double height : {6.0, 7.0}) {
                QFileSystemWatcher watcher({m_folder->path()});
                QSignalSpy seen(&watcher, &QFileSystemWatcher::directoryChanged);
                QVERIFY(saveProject(toPath(m_path), projectWithGround(height)));
                QTRY_VERIFY(seen.count() > 0);
                test::runTimersDueWithin(300);  // longer than the delay after which the file is compared
                for (const QWidget* widget : QApplication::topLevelWidgets())
                    questions += widget->isVisible() && qobject_cast<const QMessageBox*>(widget);
            }
            answer("Keep Current Version");
            press(box, "Keep Current Version");
        });
        QVERIFY(saveProject(toPath(m_path), projectWithGround(kOtherHeight)));
        QTRY_COMPARE(questions, 2);  // one each time
        QTRY_VERIFY(!QApplication::activeModalWidget());
    }
    void changeOnDiskKeepsTheEdits() {
        MainWindow& window = *editedWindow();
        const QString copy = m_folder->filePath("copy.rubble");
        test::onNextDialog<QMessageBox>([&](QMessageBox& box) {
            m_question = box.text();
            test::onNextDialog<QFileDialog>([&](QFileDialog& dialog) { saveTo(dialog, copy); });
            QTest::keyClick(&box, Qt::Key_Return);
        });
        QVERIFY(saveProject(toPath(m_path), projectWithGround(kOtherHeight)));
        QTRY_COMPARE(heightIn(copy), kEditedHeight);
        QVERIFY(m_question.contains("\"wall.rubble\" was changed by another program"));
        QTRY_COMPARE(window.workspace().file().path(), copy);
        QCOMPARE(heightIn(m_path), kOtherHeight);
    }
    void changeOnDiskIsReloadedOnRequest() {
        MainWindow& window = *editedWindow();
        answer("Reload");
        QVERIFY(saveProject(toPath(m_path), projectWithGround(kOtherHeight)));
        QTRY_COMPARE(window.workspace().project().ground.height, kOtherHeight);
        QVERIFY(!window.workspace().document().isModified());
    }
    void changeOnDiskIsCompared() {
        MainWindow& window = *editedWindow();
        answer("Compare");
        QVERIFY(saveProject(toPath(m_path), projectWithGround(kOtherHeight)));
        QTRY_VERIFY(window.findChild<CompareActions*>()->comparison().isOn());
        QCOMPARE(window.workspace().project().ground.height, kEditedHeight);
    }
    void keptVersionIsNotSavedUnasked() {
        MainWindow& window = *editedWindow();
        answer("Keep Current Version");
        QVERIFY(saveProject(toPath(m_path), projectWithGround(kOtherHeight)));
        QTRY_VERIFY(m_question.contains("changed by another program"));
        QTRY_VERIFY(!QApplication::activeModalWidget());
        answer("Overwrite");
        QVERIFY(window.fileActions().save());
        QVERIFY(m_question.contains("Overwriting it discards"));
        QCOMPARE(heightIn(m_path), kEditedHeight);
    }
    void savingLooksAtTheDiskFirst() {
        MainWindow& window = *editedWindow();
        QVERIFY(saveProject(toPath(m_path), projectWithGround(kOtherHeight)));
        answer("Cancel");
        QVERIFY(!window.fileActions().save());
        QCOMPARE(heightIn(m_path), kOtherHeight);
        QVERIFY(window.workspace().document().isModified());
    }
    void pipeInPlaceOfTheFileNeitherBlocksNorIsWritten() {
        MainWindow& window = *editedWindow();
        QVERIFY(QFile::remove(m_path));
        QCOMPARE(::mkfifo(m_path.toUtf8().constData(), 0600), 0);
        test::onNextDialog<QMessageBox>([this](QMessageBox& box) {
            m_question = box.informativeText();
            test::onNextDialog<QMessageBox>([this](QMessageBox& error) {
                m_error = error.text();
                press(error, "OK");
            });
            press(box, "Overwrite");
        });
        QVERIFY(!window.fileActions().save());
        QVERIFY2(m_question.contains("it is a pipe"), qPrintable(m_question));
        QVERIFY2(m_error.startsWith("Cannot write"), qPrintable(m_error));
        QVERIFY(window.workspace().document().isModified());
    }
    void unreadableFileIsNotOverwrittenUnasked() {
        MainWindow& window = *editedWindow();
        QFile::resize(m_path, (qint64{1} << 30) + 1);  // a sparse file
        answer("Cancel");
        QVERIFY(!window.fileActions().save());
        QVERIFY2(m_question.contains("it is larger than 1 GiB"), qPrintable(m_question));
        QCOMPARE(QFileInfo(m_path).size(), (qint64{1} << 30) + 1);
        answer("Overwrite");
        QVERIFY(window.fileActions().save());
        QCOMPARE(heightIn(m_path), kEditedHeight);
    }
    void deletionIsReportedAsDeletion() {
        MainWindow& window = *editedWindow();
        answer("Keep Current Version");
        QVERIFY(QFile::remove(m_path));
        QTRY_VERIFY(m_question.contains("\"wall.rubble\" was deleted by another program"));
        QTRY_VERIFY(!QApplication::activeModalWidget());
        QVERIFY(window.fileActions().save());
        QCOMPARE(heightIn(m_path), kEditedHeight);
    }

private:
    /// Presses a button in the next message box.
    void answer(const QString& text) {
        test::onNextDialog<QMessageBox>([this, text](QMessageBox& box) {
            m_question = box.text() + '\n' + box.informativeText();
            press(box, text);
        });
    }
    /// Leaves a backup as a program does that is killed.
    void leaveBackup(const QString& path) const {
        Backup backup = newBackup(backupFolder());
        backup.origin = {path, contentHash(projectText(projectWithGround(0.0)))};
        QVERIFY(writeBackup(backup, QByteArray::fromStdString(projectText(projectWithGround(kBackupHeight)))));
    }
    QStringList backups() const {
        QStringList paths;
        for (const QFileInfo& file : QDir(backupFolder()).entryInfoList({"*.rubble"})) paths += file.filePath();
        return paths;
    }
    void writeForeignLock() const {
        QFile file(fromPath(lockPathOf(toPath(m_path))));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("4711\nrubble\nrender01\nanother machine\nboot\nbob\n");
    }
    static void setHeight(Document& document, double height) {
        SceneSettings scene = sceneSettings(document.project());
        scene.ground.height = height;
        document.push({.text = "Move Ground", .replacements = {scene}});
    }
    MainWindow* editedWindow() {
        MainWindow* window = m_program->open(m_path);
        if (!window) qFatal("The project was not opened.");
        setHeight(window->workspace().document(), kEditedHeight);
        return window;
    }
    /// The window with the restored project; null before that.
    static MainWindow* restored() {
        for (MainWindow* window : test::windows()) {
            const double height = window->workspace().project().ground.height;
            if (window->workspace().document().isModified() && height >= kBackupHeight) return window;
        }
        return nullptr;
    }

    QTemporaryDir m_settings;
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
    QString m_question;  // the last one that was asked
    QString m_error;     // the one that followed it
    std::unique_ptr<Program> m_program;
};

RUBBLE_TEST_WITH(RecoveryTest, QApplication)
#include "RecoveryTest.moc"
