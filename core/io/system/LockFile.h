#pragma once

#include "core/io/system/LockHolder.h"
#include "core/io/system/OpenFile.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace rubble {

enum class LockTakeover {
    Stale,  // only locks of processes of this machine that have ended
    Any,    // also locks of other machines and those that name no holder; never one of a process that runs here
};

/// A file that exists while a process works on something, with the text of Qt's QLockFile: process, program, host,
/// machine and boot, one line each; then the user. The file is also locked with flock(), which ends with the process,
/// so that a process id that is used again is not mistaken for the holder. The destructor removes the file unless
/// another process has taken it over.
class LockFile {
public:
    ~LockFile();
    LockFile(const LockFile&) = delete;
    LockFile& operator=(const LockFile&) = delete;

    const std::filesystem::path& path() const { return m_path; }

    /// Also locks the file that this lock is for, whatever other names it has (hard links), until the lock ends or
    /// another file is held. Call it again after the file was replaced. Nothing is locked where the file does not exist
    /// or cannot be opened for writing, or its file system has no flock(). Returns the process that holds it by another
    /// name, if there is one.
    std::optional<LockHolder> holdFile(const std::filesystem::path& file) const;

private:
    friend struct LockAttempts;
    LockFile(std::filesystem::path path, OpenFile file) : m_path(std::move(path)), m_file(std::move(file)) {}

    std::filesystem::path m_path;
    OpenFile m_file;
    mutable std::unique_ptr<OpenFile> m_held;  // the file of holdFile()
};

/// What an attempt to create a lock file gave: the lock, the process that holds it, or why no file can be created.
struct LockAttempt {
    std::shared_ptr<const LockFile> lock;
    std::optional<LockHolder> holder;
    std::string reason;  // of the system: "Read-only file system"
};

/// Creates a lock file, without waiting.
LockAttempt lockFile(const std::filesystem::path& path, LockTakeover takeover = LockTakeover::Stale);

}  // namespace rubble
