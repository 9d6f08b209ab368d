// Tests that saving in editor/actions/FileActions.cpp repeats an export.
#include "core/asset/library/StarterProject.h"
#include "core/io/system/FolderExchange.h"
#include "editor/dialogs/ProjectExport.h"
#include "editor/document/FilePath.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/EditorStory.h"
#include "tests/support/files/FileTree.h"

#include <QProgressDialog>
#include <QStatusBar>

using namespace rubble;

class ExportOnSaveStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void init() {
        open(starterProject());
        QVERIFY(window().workspace().file().saveAs(pathOf("wall.rubble")).hasValue());
        const ExportOptions options{.folder = pathOf("packs"), .isRepeatedOnSave = true};
        exportProject(window().workspace(), options, window().views().messages(), nullptr);
    }
    void cleanup() {
        close();
        QVERIFY(QDir(pathOf("packs")).removeRecursively());
    }

    void savingExportsWhatChanged() {
        addWall();
        action("file-save")->trigger();
        QVERIFY(!document().isModified());
        QVERIFY(!QApplication::activeModalWidget());
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(pathOf("packs/wall_2/pack.json")), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(statusText().startsWith("Exported 1 asset"), kPatience);
    }
    /// Which waits here for another program until the window waits for it.
    void closingCompletesTheExport() {
        addWall();
        const auto lock = std::make_shared<std::optional<OpenFile>>(lockFolder(toPath(pathOf("packs"))).value());
        action("file-save")->trigger();
        test::onNextDialog<QProgressDialog>([lock](QProgressDialog&) { lock->reset(); });
        QVERIFY(window().close());
        QVERIFY(QFile::exists(pathOf("packs/wall_2/pack.json")));
    }
    void savingSucceedsWhereTheExportFails() {
        QVERIFY(QDir(pathOf("packs")).removeRecursively());
        writeFileTree(pathOf({}), {{"packs", "a file"}});
        addWall();
        action("file-save")->trigger();
        QVERIFY(!document().isModified());
        QTRY_VERIFY_WITH_TIMEOUT(lastMessage().severity == Severity::Error, kPatience);
        QVERIFY(!QApplication::activeModalWidget());
        QVERIFY(QFile::remove(pathOf("packs")));
    }

private:
    Document& document() { return window().workspace().document(); }
    const Message& lastMessage() { return window().views().messages().list().back(); }
    QString statusText() { return window().statusBar()->currentMessage(); }
    void addWall() { action("asset-duplicate")->trigger(); }
};

RUBBLE_TEST_WITH(ExportOnSaveStoryTest, QApplication)
#include "ExportOnSaveStoryTest.moc"
