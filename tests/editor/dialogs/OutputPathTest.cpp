#include "editor/dialogs/OutputPath.h"

#include "editor/document/DocumentFile.h"
#include "editor/document/FilePath.h"
#include "tests/support/TestProgram.h"

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QVariant>

using namespace rubble;

class OutputPathTest : public QObject {
    Q_OBJECT
private slots:
    void filesOfOtherUseAreNotWritten() {
        const QTemporaryDir folder;
        const QString project = folder.filePath("wall.rubble"), picture = folder.filePath("wall.png");
        touch(project);
        touch(picture);
        QFile::link(project, folder.filePath("link.replay"));
        QFile index(folder.filePath("export.json"));
        QVERIFY(index.open(QIODevice::WriteOnly));
        index.write(
            R"({"format": "rubble-export", "version": 1, "project": "wall.rubble", "folders": [], "files": []})");
        index.close();
        const QStringList replays{".replay"};
        QVERIFY(outputFault(folder.filePath("new.replay"), project, replays).isEmpty());
        QVERIFY(outputFault(project, project, replays).contains("is the project."));
        QVERIFY(outputFault(folder.filePath("link.replay"), project, replays).contains("is the project."));
        QVERIFY(outputFault(picture, project, replays).contains("is something else by its name"));
        QVERIFY(outputFault(index.fileName(), project, {".json"}).contains("is a file of an export."));
        QVERIFY(outputFault(project, {}, {".rubble"}).isEmpty());  // saved in its place
    }
    void existingFilesAndFoldersAreNotProposed() {
        const QTemporaryDir folder;
        QCOMPARE(unusedPath(folder.path(), "wall", ".png"), folder.filePath("wall.png"));
        touch(folder.filePath("wall.png"));
        QCOMPARE(unusedPath(folder.path(), "wall", ".png"), folder.filePath("wall 2.png"));
        QVERIFY(QDir(folder.path()).mkdir("wall 2"));  // the images of a video
        QCOMPARE(unusedPath(folder.path(), "wall", ".png"), folder.filePath("wall 3.png"));
    }
    void folderOfTheSettingIsUsedIfItExists() {
        const QTemporaryDir stored, other;
        const auto proposed = [&](const QString& setting) {
            return unusedPathIn(settingOf(setting), other.path(), "wall", ".png");
        };
        QCOMPARE(proposed(stored.path()), QDir::toNativeSeparators(stored.filePath("wall.png")));
        QCOMPARE(proposed(stored.filePath("gone")), QDir::toNativeSeparators(other.filePath("wall.png")));
    }
    void dialogsBeginBesideTheProject() {
        const QTemporaryDir folder;
        Document document{Project()};
        DocumentFile file(document);
        QVERIFY(file.saveAs(folder.filePath("house.rubble")));
        QFileDialog dialog;
        dialog.setAcceptMode(QFileDialog::AcceptSave);
        suggestOutput(dialog, file, ".csv");
        QCOMPARE(dialog.selectedFiles(), QStringList{folder.filePath("house.csv")});
        touch(folder.filePath("house.csv"));
        suggestOutput(dialog, file, ".csv");
        QCOMPARE(QFileInfo(dialog.selectedFiles().value(0)).fileName(), "house 2.csv");
    }
    void buttonAcceptsAndKeepsTheFocusInTheField() {
        QDialog dialog;
        auto* form = new QFormLayout(&dialog);
        QPushButton* button = addOutputButtons(dialog, *form, "Export");
        const QSignalSpy accepted(&dialog, &QDialog::accepted);
        QVERIFY(button->isDefault());
        QVERIFY(!(button->focusPolicy() & Qt::ClickFocus));
        button->click();
        QCOMPARE(accepted.count(), 1);
    }
    void pathsFit() {
        QDialog dialog;
        auto* form = new QFormLayout(&dialog);
        QLabel* summary = addSummary(*form, "summary");
        fitPath(dialog);
        QVERIFY(dialog.width() >= 480);
        QVERIFY(summary->wordWrap());
        QCOMPARE(summary->textFormat(), Qt::PlainText);
    }
    void browseButtonIsBesideTheField() {
        QWidget page;
        auto* path = new QLineEdit;
        int browsed = 0;
        page.setLayout(createPathRow(*path, [&] { ++browsed; }));
        page.findChild<QPushButton*>()->click();
        QCOMPARE(browsed, 1);
    }

private:
    static void touch(const QString& path) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
    }
};

RUBBLE_TEST_WITH(OutputPathTest, QApplication)
#include "OutputPathTest.moc"
