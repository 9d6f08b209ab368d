#pragma once

#include "core/base/Result.h"

#include <QLockFile>
#include <QString>

#include <memory>

namespace rubble {

/// Keeps others from editing the same project file: a hidden file beside it, ".house.rubble.lock", which names program,
/// process and machine. It goes with this object; what a process of this machine left behind that has ended is no lock.
class ProjectLock {
public:
    /// Errors: Io, saying who has the project open, or that the folder cannot be written to.
    static Result<std::shared_ptr<ProjectLock>> take(const QString& projectPath);

private:
    explicit ProjectLock(const QString& lockPath) : m_file(lockPath) {}
    QLockFile m_file;
};

/// Where the lock of a project file lies.
QString lockPathOf(const QString& projectPath);

}  // namespace rubble
