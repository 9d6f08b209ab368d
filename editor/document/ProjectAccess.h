#pragma once

#include "core/io/system/LockFile.h"

#include <QString>

#include <memory>
#include <optional>

namespace rubble {

/// The right to write a project file: its lock. Without it the project is read-only.
struct ProjectAccess {
    std::shared_ptr<const LockFile> lock;
    QString readOnlyReason;            // a sentence; empty if there is a lock
    std::optional<LockHolder> holder;  // the process that holds the lock, if that is the reason

    bool isReadOnly() const { return !lock; }
};

/// Locks a project for writing. It is read-only if another process holds the lock, and where no lock can be created: on
/// read-only media, in folders of other users, on a full disk.
ProjectAccess accessProject(const QString& path, LockTakeover takeover = LockTakeover::Stale);

/// Names the holder of a lock: "rubble, process 4711 of bob on render01, since 22/11/2026 14:03".
QString holderText(const LockHolder& holder);

}  // namespace rubble
