#pragma once

#include "core/asset/project/Project.h"
#include "core/base/Hash.h"
#include "core/base/Result.h"
#include "core/io/system/LockFile.h"

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace rubble {

/// The project file that a backup belongs to.
struct BackupOrigin {
    QString path;                     // empty if the project was never saved
    std::optional<ContentHash> hash;  // of the file that the changes are based on; none: there was no file
};

/// A backup: a project, its meshes, its journal and its origin beside it, and a lock that is held while a program uses
/// the backup.
struct Backup {
    QString path;
    BackupOrigin origin;
    QDateTime time;                        // when it was written, or its journal
    std::shared_ptr<const LockFile> lock;  // null if none could be created, as on a full disk
    std::optional<LockHolder> holder;      // another program that holds the lock and may be running
};

/// The user's folder for backups.
QString backupFolder();

/// A backup with a new name in a folder, which is created; nothing is written but the lock.
Backup newBackup(const QString& folder);
/// Locks a backup that has no lock yet, if possible.
void lockBackup(Backup& backup);
/// Writes a backup and its origin, each atomically; only the user may read them. On an error the old backup is kept.
///
/// Errors: Io, with the path and the system's reason.
Status writeBackup(const Backup& backup, const QByteArray& project);
/// Writes the closed meshes of a project's assets beside its backup, but those that are there; only the user may read
/// them. They have to be there before the text or the record that names them.
///
/// Errors: those of saveMeshes().
Status writeBackupMeshes(const Backup& backup, const Project& project);
/// Removes the closed meshes beside a backup that its project, which was just written, does not have.
void removeUnusedMeshes(const Backup& backup, const Project& project);
/// The journal of a backup: what was edited since it was written.
QString journalPath(const Backup& backup);
/// Appends to the journal of a backup, or begins it anew, and flushes it to disk; only the user may read it. On an
/// error its last record may not be whole.
///
/// Errors: Io, with the path and the system's reason.
Status appendToJournal(const Backup& backup, std::string_view bytes, bool isNew);
/// What becomes of the closed meshes beside a backup that is removed: kept, the next one need not write them.
enum class BackupMeshes { Removed, Kept };
/// Removes a backup, its journal and its origin.
void removeBackup(const Backup& backup, BackupMeshes meshes = BackupMeshes::Removed);

/// Takes the lock of a backup over from its holder. Returns false if the holder is running after all.
bool takeOverBackup(Backup& backup);

/// The backups in a folder, newest first: those whose program has ended, locked, and those of programs on other
/// computers, of which that is unknown, with their holders. Removes what other programs that were killed
/// left there: locks and unfinished files.
std::vector<Backup> orphanedBackups(const QString& folder);

}  // namespace rubble
