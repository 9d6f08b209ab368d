#include "editor/dialogs/ExportOnSave.h"

#include "tests/support/Patience.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/SavedWall.h"
#include "tests/support/files/FileTree.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

class ExportOnSaveTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_workspace = test::savedWall(*m_folder);
        m_messages = std::make_unique<Messages>();
        m_exporter = std::make_unique<ExportOnSave>(*m_workspace, *m_messages, nullptr);
    }

    void repeatsTheLastExport() {
        exportWith({.isRepeatedOnSave = true});
        test::addPrism(*m_workspace, "gable");
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
        test::addPrism(*m_workspace, "gable");
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
        test::addPrism(*m_workspace, "gable");
        m_exporter->start();
        QTRY_VERIFY_WITH_TIMEOUT(!m_exporter->isRunning(), kPatience);
        QCOMPARE(finished.size(), 1);
        QVERIFY(QFile::exists(out() + "/gable/pack.json"));
    }
    void completingWaitsForTheResult() {
        exportWith({.isRepeatedOnSave = true});
        test::addPrism(*m_workspace, "gable");
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
