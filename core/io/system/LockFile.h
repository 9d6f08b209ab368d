#pragma once

#include "core/io/system/OpenFile.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace rubble {

/// The process that holds a lock file, as far as the file names it.
struct LockHolder {
    std::string program;  // empty: unknown, as the following
    std::string user;
    std::string host;
    std::int64_t process = 0;                     // 0: unknown
    std::chrono::system_clock::time_point since;  // when the lock was taken
    /// It runs on this machine. Of a process on another machine, and of a lock file without text, that is unknown.
    bool isRunningHere = false;
    bool isThisProcess = false;
    bool isThisProgram = false;  // a process of the same program, by its file name
};

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

private:
    friend struct LockAttempts;
    LockFile(std::filesystem::path path, OpenFile file) : m_path(std::move(path)), m_file(std::move(file)) {}

    std::filesystem::path m_path;
    OpenFile m_file;
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
