// Tests editor/document/DocumentFile.cpp and editor/document/ProjectAccess.cpp.
#include "editor/document/DocumentFile.h"

#include "core/asset/library/StarterProject.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/project/ProjectLock.h"
#include "editor/document/FilePath.h"
#include "editor/document/Messages.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/MeshProjects.h"
#include "tests/support/editor/EventLoop.h"
#include "tests/support/files/FileBytes.h"
#include "tests/support/files/FileLimits.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QFileSystemWatcher>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

void setBytes(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

constexpr const char* kIdentity = "0123456789abcdef0123456789abcdef";

Project identified(Project project) {
    project.identity = kIdentity;
    return project;
}

/// The bytes that the process has read so far.
qint64 bytesRead() {
    QFile file("/proc/self/io");
    if (!file.open(QIODevice::ReadOnly)) return 0;
    return file.readLine().mid(QByteArray("rchar: ").size()).trimmed().toLongLong();
}

/// Deletes the first instance.
void edit(Document& document) {
    document.push(
        {.text = "Delete", .replacements = {Replacement<Instance>{document.project().instances[0].id, std::nullopt}}});
}

}  // namespace

class DocumentFileTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath("wall.rubble");
        setBytes(m_path, QByteArray::fromStdString(projectText(identified(starterProject()))));
    }

    void openAndSaveKeepsTheBytes() {
        Document document(emptyProject());
        DocumentFile file(document);
        const QByteArray before = bytesOfFile(m_path);
        QVERIFY(file.open(m_path));
        QCOMPARE(file.name(), "wall.rubble");
        edit(document);
        QVERIFY(file.save());
        QVERIFY(bytesOfFile(m_path) != before && !document.isModified());
        document.undoStack().undo();
        QVERIFY(file.save());
        QCOMPARE(bytesOfFile(m_path), before);
    }
    void repeatedPointsAreReportedAndSavedWithout() {
        const Project closed = identified(starterProject());
        QByteArray text = QByteArray::fromStdString(projectText(closed));
        const qsizetype start = text.indexOf("\"outline\": [") + qstrlen("\"outline\": [");
        const QByteArray first = text.mid(start, text.indexOf(']', start) + 1 - start);
        setBytes(m_path, QByteArray(text).insert(start, first + ", "));
        Document document(emptyProject());
        DocumentFile file(document);
        QSignalSpy spy(&file, &DocumentFile::noted);
        QVERIFY(file.open(m_path));
        QCOMPARE(spy.count(), 1);
        const auto notes = spy[0][0].value<std::vector<Diagnostic>>();
        QCOMPARE(notes.size(), std::size_t{1});
        QCOMPARE(noteText(notes[0], document.project()), "\"wall\": 1 repeated point of the outline was left out.");
        QVERIFY(document.project() == closed && file.diskState() == DiskState::Unchanged);
        QVERIFY(file.save());
        QCOMPARE(bytesOfFile(m_path), text);
        QVERIFY(file.reload());
        QCOMPARE(spy.count(), 1);
    }
    void copiesGetAnIdentityOfTheirOwn() {
        Document document(emptyProject());
        DocumentFile file(document);
        QVERIFY(file.saveAs(m_folder->filePath("new.rubble")));
        const std::string first = document.project().identity;
        QCOMPARE(first.size(), 32U);
        QVERIFY(file.save() && document.project().identity == first);
        QVERIFY(!file.saveAs(m_folder->filePath("no/such/folder.rubble")));
        QCOMPARE(document.project().identity, first);
        QVERIFY(file.saveAs(m_folder->filePath("copy.rubble")));
        const std::string second = document.project().identity;
        QVERIFY(second != first);
        document.undoStack().undo();
        QCOMPARE(document.project().identity, second);
        QVERIFY(file.open(m_folder->filePath("new.rubble")));
        QCOMPARE(document.project().identity, first);
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
            QCOMPARE(sentence,
                     "\"wall.rubble\" is read-only, because it is open in another window. Save it under "
                     "another name.");
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
        QVERIFY(isLocked(other) && !isLocked(m_path));
    }
    void saveAsToALinkToTheFileKeepsTheLock() {
        Document document(emptyProject());
        DocumentFile file(document);
        QVERIFY(file.open(m_path));
        const QString link = m_folder->filePath("link.rubble");
        QVERIFY(QFile::link(m_path, link));
        edit(document);
        const Status saved = file.saveAs(link);
        QVERIFY2(saved.hasValue(), saved ? "" : saved.error().message.c_str());
        QVERIFY(file.path() == link && isLocked(m_path) && !document.isModified());
        QVERIFY(loadProject(toPath(m_path))->instances.empty() && QFileInfo(link).isSymLink());
    }
    void unreadableFileIsNotUnchanged() {
        Document document(emptyProject());
        DocumentFile file(document);
        QVERIFY(file.open(m_path));
        QVERIFY(QFile::remove(m_path) && QDir().mkdir(m_path));
        QVERIFY(file.diskState() == DiskState::Unreadable);
    }
    void hardLinksOfAnOpenFileAreReadOnlyElsewhere() {
        Document document(emptyProject());
        DocumentFile file(document);
        QVERIFY(file.open(m_path));
        const QString link = m_folder->filePath("link.rubble"), third = m_folder->filePath("third.rubble");
        std::filesystem::create_hard_link(toPath(m_path), toPath(link));
        QVERIFY(accessProject(link).isReadOnly());
        edit(document);
        QVERIFY(file.saveAs(link));  // its own file by another name
        QVERIFY(QFile::remove(m_path));
        edit(document);
        QVERIFY(file.save());  // replaces the file, which has one name now
        std::filesystem::create_hard_link(toPath(link), toPath(third));
        QVERIFY(accessProject(third).isReadOnly());
    }
    void fileThatCannotBeLockedIsReadOnly() {
        setBytes(QString::fromStdString(lockPathOf(toPath(m_path)).string()),
                 "4711\nrubble\nrender01\nanother machine\nboot\nbob\n");
        Document document(emptyProject());
        DocumentFile file(document);
        const Status refused = file.open(m_path);
        QVERIFY(!refused);
        const ProjectAccess access = accessProject(m_path);
        QVERIFY(access.isReadOnly() && access.holder);
        const QString holder = holderText(*access.holder);
        QVERIFY2(holder.startsWith("rubble on \"render01\" (user bob, process 4711) since "), qPrintable(holder));
        QVERIFY(file.open(m_path, access));
        QVERIFY(file.isReadOnly() && file.readOnlyReason().contains(holder));
        edit(document);
        QVERIFY(!file.save() && document.isModified());
        QVERIFY(!file.saveAs(m_path));
        QVERIFY(file.saveAs(m_folder->filePath("copy.rubble")));
        QVERIFY(!file.isReadOnly() && !document.isModified());
        QVERIFY(!accessProject(m_path, LockTakeover::Any).isReadOnly());
    }
    void filesOfOthersAreReadOnly() {
        namespace fs = std::filesystem;
        fs::permissions(toPath(m_folder->path()), fs::perms(0755));
        fs::permissions(toPath(m_path), fs::perms(0444));
        const AsNobody nobody;
        Document document(emptyProject());
        DocumentFile file(document);
        QVERIFY(file.open(m_path));
        QVERIFY(file.isReadOnly() && document.project() == identified(starterProject()));
        QVERIFY2(file.readOnlyReason().endsWith(" cannot be written to: Permission denied. Save it to another folder."),
                 qPrintable(file.readOnlyReason()));
    }
    void fullDiskOpensReadOnly() {
        Document document(emptyProject());
        DocumentFile file(document);
        const FileSizeLimit limit(3);
        QVERIFY(file.open(m_path));
        QVERIFY(file.isReadOnly() && !isLocked(m_path));
        QVERIFY2(file.readOnlyReason().contains(": No space left on device. "), qPrintable(file.readOnlyReason()));
    }
    void everyFileNameIsOpened() {
        const std::filesystem::path folder = toPath(m_folder->path());
        for (const std::string& name : {std::string("h\xff\xfe.rubble"), std::string(248, 'x') + ".rubble"}) {
            QVERIFY(saveProject(folder / name, starterProject()));
            Document document(emptyProject());
            DocumentFile file(document);
            QVERIFY(file.open(fromPath(folder / name)));
            QVERIFY(!file.isReadOnly() && std::filesystem::exists(lockPathOf(folder / name)));
            edit(document);
            QVERIFY(file.save());
            QVERIFY(loadProject(folder / name)->instances.empty());
            QSignalSpy changes(&file, &DocumentFile::changedOnDisk);
            QVERIFY(saveProject(folder / name, starterProject()));
            QTRY_COMPARE(changes.count(), 1);
            QVERIFY(file.diskState() == DiskState::Changed);
            QVERIFY(file.save() && file.diskState() == DiskState::Unchanged);
            std::filesystem::remove(folder / name);  // QTemporaryDir cannot
        }
    }
    void everyFileNameIsRestored() {
        const std::filesystem::path folder = toPath(m_folder->path());
        const QString backups = m_folder->filePath("backups");
        for (const std::string& name : {std::string("h\xff\xfe.rubble"), std::string(248, 'x') + ".rubble"}) {
            QVERIFY(saveProject(folder / name, starterProject()));
            {
                Backup left = newBackup(backups);
                left.origin = {fromPath(folder / name), contentHash(projectText(starterProject()))};
                QVERIFY(writeBackup(left, QByteArray::fromStdString(projectText(emptyProject()))));
            }
            const std::vector<Backup> found = orphanedBackups(backups);
            QCOMPARE(found.size(), std::size_t{1});
            Document document(starterProject());
            DocumentFile file(document);
            QVERIFY(file.restore(found[0], accessProject(found[0].origin.path)));
            QVERIFY(!file.isReadOnly() && document.project().assets.empty());
            QVERIFY(file.save());
            QVERIFY(loadProject(folder / name)->assets.empty());
            removeBackup(found[0]);
            std::filesystem::remove(folder / name);
        }
    }
    void externalChangeIsDetected() {
        Document document(emptyProject());
        DocumentFile file(document);
        QVERIFY(file.open(m_path));
        QSignalSpy spy(&file, &DocumentFile::changedOnDisk);
        edit(document);
        QVERIFY(file.save());
        QVERIFY(file.diskState() == DiskState::Unchanged);
        setBytes(m_path, QByteArray::fromStdString(projectText(identified(starterProject()))));
        QTRY_COMPARE(spy.count(), 1);  // not of our own saving
        QVERIFY(file.diskState() == DiskState::Changed);
        QVERIFY(file.reload());
        QVERIFY(file.diskState() == DiskState::Unchanged);
        QCOMPARE(document.project().instances.size(), std::size_t{1});
        QVERIFY(QFile::remove(m_path));
        QTRY_COMPARE(spy.count(), 2);
        QVERIFY(file.diskState() == DiskState::Deleted);
        edit(document);
        QVERIFY(file.save());
        QVERIFY(file.diskState() == DiskState::Unchanged);
    }
    void changeOfAnotherFileReadsNothing() {
        constexpr qint64 kPadding = 8 << 20;
        setBytes(m_path, QByteArray::fromStdString(projectText(starterProject())) + QByteArray(kPadding, ' '));
        Document document(emptyProject());
        DocumentFile file(document);
        QVERIFY(file.open(m_path));
        QVERIFY(file.diskState() == DiskState::Unchanged);
        const auto age = [this] {
            return QFileInfo(m_path).metadataChangeTime().msecsTo(QDateTime::currentDateTime());
        };
        QTRY_VERIFY(age() > 2000);  // older than the clock of any file system is coarse
        const qint64 before = bytesRead();
        QFileSystemWatcher watcher({m_folder->path()});
        QSignalSpy seen(&watcher, &QFileSystemWatcher::directoryChanged);
        setBytes(m_path + ".other", "a");
        QTRY_VERIFY(seen.count() > 0);
        test::runTimersDueWithin(500);  // longer than the delay after which the file would be compared
        QVERIFY(bytesRead() - before < kPadding);
    }
    void restoredBackupIsUnsaved() {
        Document document(starterProject());
        DocumentFile file(document);
        QVERIFY(file.restore(backupOf(m_path, contentHash(bytesOfFile(m_path).toStdString())), accessProject(m_path)));
        QCOMPARE(file.path(), m_path);
        QVERIFY(document.isModified() && document.project().assets.empty());
        QVERIFY(file.diskState() == DiskState::Unchanged);
        QVERIFY(file.save());
        QCOMPARE(bytesOfFile(m_path), bytesOfFile(backupPath()));
    }
    void restoredBackupKnowsWhatItIsBasedOn() {
        Document document(emptyProject());
        DocumentFile file(document);
        QVERIFY(file.restore(backupOf(m_path, contentHash("an earlier file")), accessProject(m_path)));
        QVERIFY(file.diskState() == DiskState::Changed);
    }
    void backupIsRestoredIntoTheOpenProject() {
        Document document(emptyProject());
        DocumentFile file(document);
        QVERIFY(file.open(m_path));
        QVERIFY(file.restoreHere(backupOf(m_path, {})));
        QVERIFY(file.path() == m_path && !file.isReadOnly() && document.isModified());
        QVERIFY(document.project().assets.empty() && isLocked(m_path));
    }
    void backupIsRestoredWithoutAFile() {
        Document document(starterProject());
        DocumentFile file(document);
        QVERIFY(file.restoreWithoutFile(backupOf("/no/such/folder/wall.rubble", {})));
        QVERIFY(file.path().isEmpty() && !file.isReadOnly() && document.isModified());
        QVERIFY(file.saveAs(m_folder->filePath("restored.rubble")));
        QVERIFY(!document.isModified());
    }
    /// Older versions accepted values that can be neither saved nor loaded.
    void backupWithValuesOutOfRangeIsRestoredAndMended() {
        Project project = starterProject();
        project.instances[0].pose.position.x = 2e5;
        project.ground.height = 2000.0;
        setBytes(backupPath(), QByteArray::fromStdString(projectText(project)));
        QVERIFY(!loadProject(toPath(backupPath())));
        Document document(emptyProject());
        DocumentFile file(document);
        const auto faults = file.restore({.path = backupPath(), .origin = {m_path, {}}}, accessProject(m_path));
        QVERIFY(faults);
        QCOMPARE(faults->size(), std::size_t{2});
        QVERIFY((*faults)[0].find(": the position is (200000, ") != std::string::npos);
        QCOMPARE((*faults)[1], std::string("The ground: the height is 2000, but it must be from -1000 to 1000."));
        QVERIFY(document.project() == project && !file.save());
        edit(document);
        SceneSettings scene = sceneSettings(document.project());
        scene.ground.height = 0.0;
        QVERIFY(document.push({.text = "Move Ground", .replacements = {scene}}));
        QVERIFY(file.save());
        QVERIFY(loadProject(toPath(m_path)));
    }
    void meshesFollowTheProject() {
        const Project project = identified(test::meshProject());
        QVERIFY(saveProject(toPath(m_path), project));
        Document document(emptyProject());
        DocumentFile file(document);
        QVERIFY(file.open(m_path));
        QVERIFY(document.project() == project);
        const QString copy = m_folder->filePath("copy.rubble");
        QVERIFY(file.saveAs(copy));
        QVERIFY(QDir(m_path + ".meshes").removeRecursively());
        QVERIFY(file.reload() && document.project().assets == project.assets);
        QVERIFY(loadProject(toPath(copy))->assets == project.assets);
        const Status opened = file.open(m_path);
        QVERIFY(!opened && opened.error().message.find("Asset \"sculpture\": The file of its mesh is missing, ") !=
                               std::string::npos);
        QVERIFY(file.path() == copy && document.project().assets == project.assets);
    }
    void backupWithMeshesIsRestoredAndSaved() {
        const Project project = identified(test::meshProject());
        const Backup backup{.path = backupPath(), .origin = {m_path, {}}};
        QVERIFY(writeBackupMeshes(backup, project));
        QVERIFY(writeBackup(backup, QByteArray::fromStdString(projectText(project))));
        Document document(emptyProject());
        DocumentFile file(document);
        QVERIFY(file.restore(backup, accessProject(m_path)));
        QVERIFY(document.project() == project);
        removeBackup(backup);
        QVERIFY(file.save());
        QVERIFY(*loadProject(toPath(m_path)) == project);
    }

private:
    QString backupPath() const { return m_folder->filePath("backup.rubble"); }
    /// A backup of an empty project.
    Backup backupOf(const QString& path, std::optional<ContentHash> hash) const {
        setBytes(backupPath(), QByteArray::fromStdString(projectText(identified(emptyProject()))));
        return {.path = backupPath(), .origin = {path, hash}};
    }
    static bool isLocked(const QString& path) { return std::filesystem::exists(lockPathOf(toPath(path))); }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
};

RUBBLE_TEST_WITH(DocumentFileTest, QCoreApplication)
#include "DocumentFileTest.moc"
