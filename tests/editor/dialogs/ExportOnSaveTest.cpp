#include "editor/dialogs/ExportOnSave.h"

#include "core/asset/library/StarterProject.h"
#include "core/geometry/polygon/OutlineShapes.h"
#include "editor/commands/InstanceEdits.h"
#include "tests/support/Patience.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/TestSettings.h"
#include "tests/support/files/FileTree.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

class ExportOnSaveTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        test::keepSettingsIn(m_folder->path());
        m_workspace = std::make_unique<Workspace>(starterProject(), m_folder->filePath("backups"));
        QVERIFY(m_workspace->file().saveAs(m_folder->filePath("wall.rubble")).hasValue());
        m_messages = std::make_unique<Messages>();
        m_exporter = std::make_unique<ExportOnSave>(*m_workspace, *m_messages, nullptr);
    }

    void repeatsTheLastExport() {
        exportWith({.isRepeatedOnSave = true});
        addPrism("gable");
        QCOMPARE(sentenceAfterStart(), QString("Exported 1 asset(s) to %1; 1 unchanged.").arg(out()));
        QVERIFY(QFile::exists(out() + "/gable/pack.json"));
        QCOMPARE(m_messages->list().back().severity, Severity::Note);
    }
    void exportsOnlyWhereItIsRequested() {
        m_exporter->start();
        QVERIFY(!m_exporter->isRunning());  // never exported
        exportWith({.isRepeatedOnSave = false});
        m_exporter->start();
        QVERIFY(!m_exporter->isRunning());
    }
    void doesNothingOnceItsAssetsAreDeleted() {
        addPrism("gable");
        const std::vector<Id> gable{m_workspace->project().assets.back().id};
        exportWith({.assets = gable, .isRepeatedOnSave = true});
        m_workspace->document().push(removeAssets(m_workspace->project(), gable));
        m_exporter->start();
        QVERIFY(!m_exporter->isRunning());
    }
    void errorsBecomeMessages() {
        exportWith({.isRepeatedOnSave = true});
        QVERIFY(QDir(out()).removeRecursively());
        writeFileTree(m_folder->path(), {{"packs", "a file"}});
        QVERIFY(sentenceAfterStart().contains("packs"));
        QCOMPARE(m_messages->list().back().severity, Severity::Error);
        QVERIFY(!QApplication::activeModalWidget());
    }
    void changedFilesAreKept() {
        exportWith({.isRepeatedOnSave = true});
        writeFileTree(out(), {{"wall/pack.json", "mine"}});
        QCOMPARE(sentenceAfterStart(), QString("Exported 0 asset(s) to %1; 1 kept as changed.").arg(out()));
        QCOMPARE(fileTree(out())["wall/pack.json"], "mine");
        QVERIFY(std::ranges::count(m_messages->list(), Severity::Warning, &Message::severity) == 1);
    }
    void newExportReplacesARunningOne() {
        exportWith({.isRepeatedOnSave = true});
        QSignalSpy finished(m_exporter.get(), &ExportOnSave::finished);
        m_exporter->start();
        addPrism("gable");
        m_exporter->start();
        QTRY_VERIFY_WITH_TIMEOUT(!m_exporter->isRunning(), kPatience);
        QCOMPARE(finished.size(), 1);
        QVERIFY(QFile::exists(out() + "/gable/pack.json"));
    }
    void completingWaitsForTheResult() {
        exportWith({.isRepeatedOnSave = true});
        addPrism("gable");
        QSignalSpy finished(m_exporter.get(), &ExportOnSave::finished);
        m_exporter->start();
        m_exporter->complete(nullptr);
        QVERIFY(!m_exporter->isRunning());
        QVERIFY(QFile::exists(out() + "/gable/pack.json"));
        m_exporter->complete(nullptr);  // there is none
        QCOMPARE(finished.size(), 1);
    }

private:
    QString out() const { return m_folder->filePath("packs"); }
    void exportWith(ExportOptions options) {
        options.folder = out();
        exportProject(*m_workspace, options, *m_messages, nullptr);
    }
    void addPrism(const char* name) {
        m_workspace->document().push(
            addAsset(m_workspace->project(), name, {isoscelesTriangleOutline(2.0, 1.0), 0.5}).edit);
    }
    QString sentenceAfterStart() {
        QSignalSpy finished(m_exporter.get(), &ExportOnSave::finished);
        m_exporter->start();
        [&] { QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, kPatience); }();
        return finished.isEmpty() ? QString() : finished.front().front().toString();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Workspace> m_workspace;
    std::unique_ptr<Messages> m_messages;
    std::unique_ptr<ExportOnSave> m_exporter;
};

RUBBLE_TEST_WITH(ExportOnSaveTest, QApplication)
#include "ExportOnSaveTest.moc"
