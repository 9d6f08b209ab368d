#pragma once

#include "core/base/Hash.h"
#include "core/base/Result.h"
#include "core/io/system/LockFile.h"

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace rubble {

/// The project file that a backup belongs to.
struct BackupOrigin {
    QString path;                     // empty if the project was never saved
    std::optional<ContentHash> hash;  // of the file that the changes are based on; none: there was no file
};

/// A backup: a project, its origin beside it, and a lock that is held while a program uses the backup.
struct Backup {
    QString path;
    BackupOrigin origin;
    QDateTime time;                        // when it was written
    std::shared_ptr<const LockFile> lock;  // null if none could be created, as on a full disk
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
/// Removes a backup and its origin.
void removeBackup(const Backup& backup);

/// The backups in a folder whose program has ended, newest first, locked. Removes what other programs that were killed
/// left there: locks and unfinished files.
std::vector<Backup> orphanedBackups(const QString& folder);

}  // namespace rubble
