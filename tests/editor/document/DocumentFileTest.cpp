#include "core/asset/project/StarterProject.h"
#include "core/io/project/ProjectFile.h"
#include "editor/document/DocumentFile.h"
#include "tests/support/TestProgram.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void setBytes(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

/// Deletes the first instance.
void edit(Document& document) {
    document.push({.text = "Delete", .swaps = {Swap<Instance>{document.project().instances[0].id, std::nullopt}}});
}

}  // namespace

class DocumentFileTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath("wall.rubble");
        setBytes(m_path, QByteArray::fromStdString(projectText(starterProject())));
    }

    void openAndSaveKeepsTheBytes() {
        Document document(emptyProject());
        DocumentFile file(document);
        const QByteArray before = bytesOf(m_path);
        QVERIFY(file.open(m_path));
        QCOMPARE(file.name(), "wall.rubble");
        edit(document);
        QVERIFY(file.save());
        QVERIFY(bytesOf(m_path) != before && !document.isModified());
        document.undoStack().undo();
        QVERIFY(file.save());
        QCOMPARE(bytesOf(m_path), before);
    }
    void invalidFileLeavesTheDocument() {
        setBytes(m_path, "{");
        Document document(starterProject());
        DocumentFile file(document);
        edit(document);
        QVERIFY(!file.open(m_path));
        QVERIFY(file.path().isEmpty() && document.isModified());
        QVERIFY(!file.saveAs(m_folder->filePath("no/such/folder.rubble")));
        QVERIFY(file.path().isEmpty() && document.isModified());
    }
    void openFileIsLocked() {
        Document document(emptyProject()), other(emptyProject());
        DocumentFile second(other);
        {
            DocumentFile first(document);
            QVERIFY(first.open(m_path));
            QVERIFY(QFile::exists(m_folder->filePath(".wall.rubble.lock")));
            const Status refused = second.open(m_path);
            QVERIFY(!refused);
            const QString sentence = QString::fromStdString(refused.error().message);
            QVERIFY2(sentence.startsWith("\"wall.rubble\" is already open in "), qPrintable(sentence));
            QVERIFY(sentence.contains(QString(", process %1.").arg(QCoreApplication::applicationPid())));
            QVERIFY(!second.saveAs(m_path));
        }
        QVERIFY(second.open(m_path));
    }
    void saveAsMovesTheLock() {
        Document document(emptyProject());
        DocumentFile file(document);
        QVERIFY(file.open(m_path));
        const QString other = m_folder->filePath("other.rubble");
        QVERIFY(file.saveAs(other));
        QCOMPARE(file.path(), other);
        QVERIFY(QFile::exists(lockPathOf(other)) && !QFile::exists(lockPathOf(m_path)));
    }
    void externalChangeIsDetected() {
        Document document(emptyProject());
        DocumentFile file(document);
        QVERIFY(file.open(m_path));
        QSignalSpy spy(&file, &DocumentFile::changedOnDisk);
        edit(document);
        QVERIFY(file.save());
        QTest::qWait(50);
        QCOMPARE(spy.count(), 0);  // our own writing is not reported
        setBytes(m_path, QByteArray::fromStdString(projectText(starterProject())));
        QTRY_COMPARE(spy.count(), 1);
        QVERIFY(file.reload());
        QCOMPARE(document.project().instances.size(), std::size_t{1});
        QVERIFY(QFile::remove(m_path));
        QTRY_COMPARE(spy.count(), 2);
    }
    void restoredBackupIsUnsaved() {
        const QString backup = m_folder->filePath("backup.rubble");
        setBytes(backup, QByteArray::fromStdString(projectText(emptyProject())));
        Document document(starterProject());
        DocumentFile file(document);
        QVERIFY(file.restore(backup, m_path));
        QCOMPARE(file.path(), m_path);
        QVERIFY(document.isModified() && document.project().assets.empty());
        QVERIFY(file.save());
        QCOMPARE(bytesOf(m_path), bytesOf(backup));
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
};

RUBBLE_TEST_WITH(DocumentFileTest, QCoreApplication)
#include "DocumentFileTest.moc"
