#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/io/system/LockFile.h"

#include <filesystem>
#include <memory>

namespace rubble {

/// The path of the lock file of a project: ".house.rubble.lock" beside it. Symbolic links to one project share a lock.
/// A name that would be longer than file systems allow is shortened and made unique by its hash.
std::filesystem::path lockPathOf(const std::filesystem::path& project);

/// Locks a project, which need not exist yet, for writing: by its lock file, and the file itself, which may have other
/// names. A project that may not be written to gives a reason instead.
LockAttempt lockProject(const std::filesystem::path& project, LockTakeover takeover = LockTakeover::Stale);

/// Locks a project for a program that reads, changes and writes it without a user. Waits up to a minute while another
/// process of the same program does so; a different program, such as the editor, may hold the lock for hours. Takes
/// over locks of processes that have ended, and those that name no process and are older than a few seconds.
///
/// Errors: Io if another process holds the lock, which the message names, or if the project or its folder cannot be
/// written to; Cancelled.
Result<std::shared_ptr<const LockFile>> waitForProjectLock(const std::filesystem::path& project,
                                                           const CancelToken& cancel);

}  // namespace rubble
