#pragma once

#include "core/base/Result.h"

#include <QLockFile>
#include <QString>

#include <memory>

namespace rubble {

/// Keeps other programs from editing the same project file: a hidden file beside it, ".house.rubble.lock", with the
/// name of the program, process and machine. The destructor removes it; a lock left by a process of this machine that
/// has ended is ignored.
class ProjectLock {
public:
    /// Errors: Io if another process holds the lock, which the message names, or the folder is not writable.
    static Result<std::shared_ptr<ProjectLock>> acquire(const QString& projectPath);

private:
    explicit ProjectLock(const QString& lockPath) : m_file(lockPath) {}
    QLockFile m_file;
};

/// The path of a project file's lock.
QString lockPathOf(const QString& projectPath);

}  // namespace rubble
