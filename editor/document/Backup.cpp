#include "editor/document/Backup.h"

#include "core/io/project/MeshFolder.h"
#include "core/io/system/FileErrors.h"
#include "core/io/system/OpenFile.h"
#include "core/io/system/Temporary.h"
#include "editor/document/FilePath.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QUuid>

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <set>
#include <string_view>

namespace rubble {

namespace {

constexpr const char* kBackupSuffix = ".rubble";
constexpr const char* kLockSuffix = ".lock";
constexpr const char* kOriginSuffix = ".json";
constexpr const char* kJournalSuffix = ".journal";
constexpr const char* kMeshesSuffix = ".rubble.meshes";  // as meshFolderOf() the backup
constexpr const char* kProjectKey = "project";
constexpr const char* kBytesKey = "projectBytes";  // base64 of a path that is not UTF-8
constexpr const char* kHashKey = "projectHash";
constexpr QFile::Permissions kOnlyOwner = QFile::ReadOwner | QFile::WriteOwner;

QString withSuffix(const QString& backupPath, const char* suffix) {
    return backupPath.chopped(static_cast<int>(qstrlen(kBackupSuffix))) + suffix;
}

Status written(const QString& path, const QByteArray& bytes) {
    TemporaryFile file;
    const std::filesystem::path target = toPath(path);
    int code = file.create(target.parent_path(), 0600);
    if (code == 0) code = writeAll(file.descriptor(), {bytes.data(), static_cast<std::size_t>(bytes.size())});
    if (code != 0) return cannotWrite(target, code);
    return file.renameTo(target, target);
}

std::filesystem::path meshFolder(const Backup& backup) { return toPath(withSuffix(backup.path, kMeshesSuffix)); }

void removeMeshes(const Backup& backup) {
    std::error_code ignored;
    std::filesystem::remove_all(meshFolder(backup), ignored);
}

QByteArray originText(const BackupOrigin& origin) {
    const std::string bytes = toPath(origin.path).native();
    QJsonObject object{{kProjectKey, origin.path}};
    if (QString::fromStdString(bytes) != origin.path) {
        object.insert(kBytesKey, QString::fromLatin1(QByteArray::fromStdString(bytes).toBase64()));
    }
    if (origin.hash) object.insert(kHashKey, QString::fromStdString(origin.hash->hex()));
    return QJsonDocument(object).toJson();
}

BackupOrigin originOf(const QString& backupPath) {
    QFile file(withSuffix(backupPath, kOriginSuffix));
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QJsonObject object = QJsonDocument::fromJson(file.readAll()).object();
    BackupOrigin origin{.path = object.value(kProjectKey).toString(),
                        .hash = parseContentHash(object.value(kHashKey).toString().toStdString())};
    if (object.contains(kBytesKey)) {
        const QByteArray bytes = QByteArray::fromBase64(object.value(kBytesKey).toString().toLatin1());
        origin.path = fromPath(bytes.toStdString());
    }
    return origin;
}

/// Whether a program may be using the backup; if not, it is locked where that is possible. Names the holder unless it
/// is known to be running.
bool isInUse(Backup& backup) {
    const std::filesystem::path path = toPath(withSuffix(backup.path, kLockSuffix));
    LockAttempt attempt = lockFile(path);
    const bool isNameless = attempt.holder && attempt.holder->process == 0;  // killed while it wrote the lock
    if (isNameless) attempt = lockFile(path, LockTakeover::Any);
    backup.lock = attempt.lock;
    if (attempt.holder && !attempt.holder->isRunningHere) backup.holder = attempt.holder;
    return attempt.holder.has_value();
}

/// Removes the lock and the origin of a program that was killed and left no backup.
void removeOrphanedLock(const QString& folder, const QString& lockName) {
    const QString name = lockName.chopped(static_cast<int>(qstrlen(kLockSuffix)));
    Backup backup{.path = folder + '/' + name + kBackupSuffix};
    if (QFile::exists(backup.path) || isInUse(backup)) return;
    for (const char* suffix : {kJournalSuffix, kOriginSuffix}) QFile::remove(withSuffix(backup.path, suffix));
    removeMeshes(backup);
}

}  // namespace

QString backupFolder() { return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/backups"; }

Backup newBackup(const QString& folder) {
    if (!QDir(folder).exists() && QDir().mkpath(folder)) QFile::setPermissions(folder, kOnlyOwner | QFile::ExeOwner);
    Backup backup{.path = folder + '/' + QUuid::createUuid().toString(QUuid::WithoutBraces) + kBackupSuffix};
    lockBackup(backup);
    return backup;
}

void lockBackup(Backup& backup) {
    if (!backup.lock) backup.lock = lockFile(toPath(withSuffix(backup.path, kLockSuffix))).lock;
}

Status writeBackup(const Backup& backup, const QByteArray& project) {
    const Status status = written(withSuffix(backup.path, kOriginSuffix), originText(backup.origin));
    return status ? written(backup.path, project) : status;
}

Status writeBackupMeshes(const Backup& backup, const Project& project) {
    const std::filesystem::path folder = meshFolder(backup);
    if (!std::ranges::all_of(project.assets, &Asset::isPrism)) ::mkdir(folder.c_str(), 0700);  // or saveMeshes() fails
    return saveMeshes(project, folder);
}

void removeUnusedMeshes(const Backup& backup, const Project& project) {
    std::set<std::filesystem::path> used;
    for (const Asset& asset : project.assets) {
        if (const ClosedMesh* mesh = asset.mesh()) used.insert(meshPath(meshFolder(backup), mesh->hash));
    }
    std::error_code ignored;
    for (const auto& file : std::filesystem::directory_iterator(meshFolder(backup), ignored)) {
        if (!used.contains(file.path())) std::filesystem::remove(file.path(), ignored);
    }
}

QString journalPath(const Backup& backup) { return withSuffix(backup.path, kJournalSuffix); }

Status appendToJournal(const Backup& backup, std::string_view bytes, bool isNew) {
    const std::filesystem::path path = toPath(journalPath(backup));
    OpenFile file(path, O_WRONLY | O_CREAT | O_NOFOLLOW | (isNew ? O_TRUNC : O_APPEND), 0600);
    int code = file.isOpen() ? writeAll(file.descriptor(), bytes) : errno;
    if (code == 0 && ::fdatasync(file.descriptor()) != 0) code = errno;
    if (code == 0 && file.close() != 0) code = errno;
    return code == 0 ? success() : Status(cannotWrite(path, code));
}

void removeBackup(const Backup& backup, BackupMeshes meshes) {
    for (const char* suffix : {kBackupSuffix, kJournalSuffix, kOriginSuffix})
        QFile::remove(withSuffix(backup.path, suffix));
    if (meshes == BackupMeshes::Removed) removeMeshes(backup);
}

bool takeOverBackup(Backup& backup) {
    LockAttempt attempt = lockFile(toPath(withSuffix(backup.path, kLockSuffix)), LockTakeover::Any);
    backup.lock = std::move(attempt.lock);
    backup.holder = std::move(attempt.holder);
    return !backup.holder;
}

std::vector<Backup> orphanedBackups(const QString& folder) {
    removeLeftovers(toPath(folder));
    for (const QString& lock : QDir(folder).entryList({QString("*") + kLockSuffix}, QDir::Files)) {
        removeOrphanedLock(folder, lock);
    }
    std::vector<Backup> backups;
    for (const QFileInfo& file : QDir(folder).entryInfoList({QString("*") + kBackupSuffix}, QDir::Files)) {
        Backup backup{.path = file.absoluteFilePath(), .time = file.lastModified()};
        if (isInUse(backup) && !backup.holder) continue;
        const QFileInfo journal(journalPath(backup));
        if (journal.exists()) backup.time = std::max(backup.time, journal.lastModified());
        backup.origin = originOf(backup.path);
        backups.push_back(std::move(backup));
    }
    std::ranges::stable_sort(backups, [](const Backup& a, const Backup& b) { return a.time > b.time; });
    return backups;
}

}  // namespace rubble
