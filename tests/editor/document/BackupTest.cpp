#include "editor/document/Backup.h"

#include "core/io/project/MeshFolder.h"
#include "editor/document/FilePath.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/MeshProjects.h"
#include "tests/support/files/FileLimits.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

using namespace rubble;

namespace {

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

}  // namespace

class BackupTest : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_backups = m_folder->filePath("backups");
    }

    void originIsKept() {
        const QString path = fromPath("/home/h\xff/w\u00e4nd.rubble");
        leaveBackup({path, contentHash("content")});
        leaveBackup({});
        std::vector<Backup> left = orphanedBackups(m_backups);
        QCOMPARE(left.size(), std::size_t{2});
        if (left[0].origin.path.isEmpty()) std::swap(left[0], left[1]);
        QCOMPARE(left[0].origin.path, path);
        QVERIFY(left[0].origin.hash == contentHash("content"));
        QVERIFY(left[1].origin.path.isEmpty() && !left[1].origin.hash);
    }
    void onlyTheOwnerReadsBackups() {
        leaveBackup({"/home/user/wall.rubble", {}});
        constexpr QFile::Permissions kOthers = QFile::ReadGroup | QFile::WriteGroup | QFile::ExeGroup |
                                               QFile::ReadOther | QFile::WriteOther | QFile::ExeOther;
        QVERIFY(!(QFile::permissions(m_backups) & kOthers));
        const QFileInfoList files = QDir(m_backups).entryInfoList(QDir::Files | QDir::Hidden);
        QCOMPARE(files.size(), 2);
        for (const QFileInfo& file : files) QVERIFY2(!(file.permissions() & kOthers), qPrintable(file.fileName()));
    }
    void earlierPermissionsAreTightened() {
        const Backup backup = newBackup(m_backups);
        write(backup.path, "old");
        QVERIFY(QFile::setPermissions(backup.path, QFile::ReadOwner | QFile::WriteOwner | QFile::ReadOther));
        QVERIFY(writeBackup(backup, "new"));
        QVERIFY(!(QFile::permissions(backup.path) & QFile::ReadOther));
    }
    void meshesAreWrittenOnceAndOnlyTheOwnerReadsThem() {
        const Backup backup = newBackup(m_backups);
        const Project project = test::meshProject();
        const auto path = meshPath(meshFolderOf(toPath(backup.path)), project.assets[1].mesh()->hash);
        QVERIFY(writeBackupMeshes(backup, boxProject(UniformScatter{})));
        QVERIFY(!std::filesystem::exists(path.parent_path()));
        QVERIFY(writeBackupMeshes(backup, project));
        QCOMPARE(std::filesystem::status(path.parent_path()).permissions(), std::filesystem::perms::owner_all);
        const auto written = std::filesystem::last_write_time(path) - std::chrono::hours(1);
        std::filesystem::last_write_time(path, written);
        QVERIFY(writeBackupMeshes(backup, project));
        QVERIFY(std::filesystem::last_write_time(path) == written);
        const Project other = test::meshProject(test::torus(8, 6));
        QVERIFY(writeBackupMeshes(backup, other));
        removeUnusedMeshes(backup, other);
        QVERIFY(!std::filesystem::exists(path));
        removeBackup(backup, BackupMeshes::Kept);
        QVERIFY(std::filesystem::exists(path.parent_path()));
        removeBackup(backup);
        QVERIFY(!std::filesystem::exists(path.parent_path()));
    }
    void meshesOfAProgramThatWasKilledAreRemoved() {
        const Backup left{.path = newBackup(m_backups).path};
        write(left.path.chopped(7) + ".lock", "");
        QVERIFY(writeBackupMeshes(left, test::meshProject()));
        QVERIFY(orphanedBackups(m_backups).empty());
        QVERIFY(!std::filesystem::exists(meshFolderOf(toPath(left.path))));
    }
    void oneProgramAtATimeIsOffered() {
        leaveBackup({});
        const std::vector<Backup> first = orphanedBackups(m_backups);
        QCOMPARE(first.size(), std::size_t{1});
        QVERIFY(first[0].lock);
        QVERIFY(orphanedBackups(m_backups).empty());
    }
    void backupOfAnotherComputerIsOfferedWithItsHolder() {
        leaveBackup({});
        const QString lock = orphanedBackups(m_backups)[0].path.chopped(7) + ".lock";
        write(lock, "4711\nrubble\nrender01\nanother machine\nboot\nbob\n");
        write(m_backups + "/unwritten.lock", "4712\nrubble\nrender01\nanother machine\nboot\nbob\n");
        std::vector<Backup> left = orphanedBackups(m_backups);
        QCOMPARE(left.size(), std::size_t{1});
        QVERIFY(!left[0].lock && left[0].holder && left[0].holder->host == "render01");
        QVERIFY(QFile::exists(m_backups + "/unwritten.lock"));
        QVERIFY(takeOverBackup(left[0]) && left[0].lock && !left[0].holder);
        QVERIFY(orphanedBackups(m_backups).empty());  // this program uses it
    }
    void fullDiskHidesNoBackup() {
        leaveBackup({});
        const FileSizeLimit limit(3);  // too little for a lock
        QCOMPARE(orphanedBackups(m_backups).size(), std::size_t{1});
    }
    void failedWriteKeepsTheOldBackup() {
        const Backup backup = newBackup(m_backups);
        QVERIFY(writeBackup(backup, "old"));
        {
            const FileSizeLimit limit(100);
            QVERIFY(!writeBackup(backup, QByteArray(1000, 'x')));
        }
        QFile file(backup.path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("old"));
    }
    void leftoversOfKilledProgramsAreRemoved() {
        QVERIFY(QDir().mkpath(m_backups));
        write(m_backups + "/killed.lock", "");  // before anything was written
        write(m_backups + "/killed.json", "{}");
        write(m_backups + "/.rubble-4711-0123456789abcdef.tmp", "half a project");
        const Backup running = newBackup(m_backups);
        QVERIFY(orphanedBackups(m_backups).empty());
        QCOMPARE(QDir(m_backups).entryList(QDir::Files | QDir::Hidden),
                 QStringList{QFileInfo(running.path).completeBaseName() + ".lock"});
    }

private:
    void leaveBackup(const BackupOrigin& origin) const {
        Backup backup = newBackup(m_backups);
        backup.origin = origin;
        QVERIFY(writeBackup(backup, "project"));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_backups;
};

RUBBLE_TEST_WITH(BackupTest, QCoreApplication)
#include "BackupTest.moc"
