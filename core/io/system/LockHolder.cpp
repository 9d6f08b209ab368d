#include "core/io/system/LockHolder.h"

#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

namespace rubble {
namespace {

std::filesystem::path folderOf(pid_t process) { return "/proc/" + std::to_string(process); }

/// The name of the file of a process; the kernel's name for it where the file cannot be seen, as for other users.
std::string programOf(pid_t process) {
    std::error_code error;
    const std::filesystem::path file = std::filesystem::read_symlink(folderOf(process) / "exe", error);
    if (!error) return file.filename().string();
    std::ifstream names(folderOf(process) / "comm");
    std::string name;
    std::getline(names, name);
    return name;
}

/// The process in a line of /proc/locks that holds an inode with flock(); 0 if the line is about another lock:
/// "1: FLOCK  ADVISORY  WRITE 1203 fe:00:10953061 0 EOF".
pid_t holderInLine(const std::string& line, ino_t inode) {
    std::istringstream words(line);
    std::string number, kind, mode, access, process, file;
    words >> number >> kind >> mode >> access >> process >> file;
    if (kind != "FLOCK" || file.substr(file.rfind(':') + 1) != std::to_string(inode)) return 0;
    pid_t id = 0;
    std::from_chars(process.data(), process.data() + process.size(), id);
    return id;
}

LockHolder holderOf(pid_t process) {
    LockHolder holder{.program = programOf(process), .host = hostName(), .process = process, .isRunningHere = true};
    holder.since = std::chrono::system_clock::now();
    struct stat status {};
    if (::stat(folderOf(process).c_str(), &status) == 0) {
        holder.user = userName(status.st_uid);
        holder.since = std::chrono::system_clock::from_time_t(status.st_mtime);
    }
    holder.isThisProcess = process == ::getpid();
    holder.isThisProgram = !holder.program.empty() && holder.program == programName();
    return holder;
}

}  // namespace

std::string hostName() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : std::string();
}

std::string programName() {
    std::error_code error;
    return std::filesystem::read_symlink("/proc/self/exe", error).filename().string();
}

std::string userName(uid_t id) {
    std::array<char, 4096> buffer{};
    passwd entry{};
    passwd* found = nullptr;
    if (::getpwuid_r(id, &entry, buffer.data(), buffer.size(), &found) != 0 || !found) return std::to_string(id);
    return found->pw_name;
}

LockHolder holderOfInode(ino_t inode) {
    std::ifstream locks("/proc/locks");
    for (std::string line; std::getline(locks, line);) {
        const pid_t process = holderInLine(line, inode);
        if (process <= 0) continue;
        LockHolder holder = holderOf(process);
        if (!holder.program.empty()) return holder;  // it has ended otherwise
    }
    return {.since = std::chrono::system_clock::now(), .isRunningHere = true};
}

}  // namespace rubble
