#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include <sys/types.h>

namespace rubble {

/// The process that holds a lock, as far as that is known.
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

/// The name of this machine.
std::string hostName();
/// The name of this program's file, which QLockFile compares with that of the running process.
std::string programName();
/// The name of a user; the id where it has none.
std::string userName(uid_t id);

/// The process of this machine that holds a file with flock(), by the number of its inode: from /proc/locks. Where that
/// does not name it, as in a container, an unknown process that runs here.
LockHolder holderOfInode(ino_t inode);

}  // namespace rubble
