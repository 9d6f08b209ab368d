#include "core/io/project/ProjectLock.h"

#include "core/base/MessageText.h"
#include "core/io/system/FileName.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <string>
#include <system_error>
#include <thread>

namespace rubble {
namespace {

/// The path without symbolic links; that of a missing file in a missing folder is only made absolute.
std::filesystem::path realPath(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::path real = std::filesystem::weakly_canonical(path, error);
    return error ? std::filesystem::absolute(path, error) : real;
}

/// Returns whether a lock was left by a process that was killed before it wrote its name.
bool isAbandoned(const LockHolder& holder) {
    constexpr std::chrono::seconds kTimeToWrite{5};
    return holder.process == 0 && std::chrono::system_clock::now() - holder.since > kTimeToWrite;
}

Error heldBy(const LockHolder& holder, const std::filesystem::path& project) {
    const std::string program = holder.program.empty() ? "another program" : shownName(holder.program);
    const std::string machine = holder.host.empty() ? "" : " on " + shownName(holder.host);
    const std::string process = holder.process == 0 ? "" : ", process " + std::to_string(holder.process);
    const std::string advice = holder.isRunningHere ? "Save and close it there first."
                                                    : "Save and close it there first; if that program has ended, "
                                                      "delete " +
                                                          quotedPath(lockPathOf(project)) + ".";
    return {ErrorCode::Io, quotedPath(project) + " is already open in " + program + machine + process + ". " + advice};
}

}  // namespace

std::filesystem::path lockPathOf(const std::filesystem::path& project) {
    const std::filesystem::path real = realPath(project);
    return real.parent_path() / fittingFileName(".", real.filename().string(), ".lock");
}

LockAttempt lockProject(const std::filesystem::path& project, LockTakeover takeover) {
    if (::faccessat(AT_FDCWD, project.c_str(), W_OK, AT_EACCESS) != 0 && errno != ENOENT) {
        return {.reason = std::generic_category().message(errno)};
    }
    LockAttempt attempt = lockFile(lockPathOf(project), takeover);
    if (!attempt.lock) return attempt;
    if (std::optional<LockHolder> holder = attempt.lock->holdFile(project)) return {.holder = std::move(holder)};
    return attempt;
}

Result<std::shared_ptr<const LockFile>> waitForProjectLock(const std::filesystem::path& project,
                                                           const CancelToken& cancel) {
    constexpr std::chrono::minutes kPatience{1};
    constexpr std::chrono::milliseconds kPause{20};
    const auto end = std::chrono::steady_clock::now() + kPatience;
    for (;;) {
        LockAttempt attempt = lockProject(project);
        if (attempt.holder && isAbandoned(*attempt.holder)) attempt = lockProject(project, LockTakeover::Any);
        if (attempt.lock) return attempt.lock;
        if (!attempt.holder)
            return Error{ErrorCode::Io, "Cannot write " + quotedPath(project) + ": " + attempt.reason + "."};
        if (cancel.isCancelled()) return TaskContext::cancelled();
        const bool isBrief = attempt.holder->isThisProgram || attempt.holder->process == 0;
        if (!isBrief || std::chrono::steady_clock::now() >= end) return heldBy(*attempt.holder, project);
        std::this_thread::sleep_for(kPause);
    }
}

}  // namespace rubble
