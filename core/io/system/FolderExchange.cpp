#include "core/io/system/FolderExchange.h"

#include "core/io/system/AtomicFile.h"
#include "core/io/system/FileErrors.h"

#include <poll.h>
#include <sys/file.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace rubble {
namespace {

namespace fs = std::filesystem;

/// Replaces a folder by a new one where the file system cannot exchange them: a process that is killed between the two
/// renames leaves the old folder to removeLeftovers().
Status moveAndReplace(const TemporaryFolder& replacement, const fs::path& folder) {
    const auto old = TemporaryFolder::createForOldContents(replacement);
    if (!old) return old.error();
    const fs::path earlier = (*old)->path() / folder.filename();
    std::error_code error;
    const bool hadEarlier = fs::exists(fs::symlink_status(folder, error));
    if (hadEarlier && ::rename(folder.c_str(), earlier.c_str()) != 0) return cannotWrite(folder, errno);
    int code = ::rename(replacement.path().c_str(), folder.c_str()) == 0 ? 0 : errno;
    if (code == 0) {
        code = syncFolder(folder.parent_path());  // before the old folder is removed
        if (code == 0) return success();
        if (::rename(folder.c_str(), replacement.path().c_str()) != 0) {
            (*old)->release();
            return cannotWrite(folder, code);
        }
    }
    if (hadEarlier && ::rename(earlier.c_str(), folder.c_str()) != 0) (*old)->release();
    return cannotWrite(folder, code);
}

}  // namespace

Result<OpenFile> lockFolder(const fs::path& folder, const TaskContext& task) {
    constexpr int kLockPollMilliseconds = 10;
    OpenFile lock(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY);
    if (!lock.isOpen()) return cannotRead(folder, errno);
    while (::flock(lock.descriptor(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        if (task.isCancelled()) return TaskContext::cancelled();
        ::poll(nullptr, 0, kLockPollMilliseconds);
    }
    return lock;
}

Status replaceFolder(const TemporaryFolder& replacement, const fs::path& folder) {
    const auto rename = [&](unsigned flags) {
        return ::renameat2(AT_FDCWD, replacement.path().c_str(), AT_FDCWD, folder.c_str(), flags) == 0 ? 0 : errno;
    };
    int code = rename(RENAME_NOREPLACE);
    const bool isExchange = code == EEXIST;
    if (isExchange) code = rename(RENAME_EXCHANGE);
    if (code == EINVAL || code == ENOSYS) return moveAndReplace(replacement, folder);
    if (code != 0) return cannotWrite(folder, code);
    code = syncFolder(folder.parent_path());
    if (code == 0) return success();
    if (isExchange) {
        static_cast<void>(rename(RENAME_EXCHANGE));
    } else {
        static_cast<void>(::rename(folder.c_str(), replacement.path().c_str()));
    }
    return cannotWrite(folder, code);
}

}  // namespace rubble
