#include "core/io/system/LockFile.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <system_error>
#include <thread>
#include <utility>

namespace rubble {
namespace {

constexpr int kAttempts = 50;  // while another process creates or removes the file
constexpr std::chrono::milliseconds kPause{2};
constexpr std::size_t kMaxText = 4096;  // bytes

std::string firstLineOfFile(const char* path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

std::string machineId() { return firstLineOfFile("/etc/machine-id"); }

std::string bootId() { return firstLineOfFile("/proc/sys/kernel/random/boot_id"); }

std::string ownText() {
    std::string text = std::to_string(::getpid());
    for (const std::string& line : {programName(), hostName(), machineId(), bootId(), userName(::geteuid())}) {
        text += '\n' + line;
    }
    return text + '\n';
}

/// The lines of a lock file; missing ones are empty.
struct LockText {
    explicit LockText(const std::string& text) {
        std::size_t from = 0;
        for (std::string* line : {&process, &program, &host, &machine, &boot, &user}) {
            const std::size_t end = std::min(text.find('\n', from), text.size());
            *line = text.substr(from, end - from);
            from = std::min(end + 1, text.size());
        }
    }
    std::int64_t processId() const {
        const bool isNumber =
            !process.empty() && process.size() < 18 && process.find_first_not_of("0123456789") == std::string::npos;
        return isNumber ? std::stoll(process) : 0;
    }
    bool isOfThisMachine() const {
        if (processId() == 0) return false;
        const std::string here = machineId();
        return machine.empty() || here.empty() ? host == hostName() : machine == here;
    }
    /// For file systems without flock(). A process id that is used again is taken for the holder.
    bool hasLivingProcess() const {
        if (!boot.empty() && boot != bootId()) return false;
        return ::kill(static_cast<pid_t>(processId()), 0) == 0 || errno == EPERM;
    }

    std::string process, program, host, machine, boot, user;
};

std::string readText(int descriptor) {
    std::string text(kMaxText, '\0');
    const ssize_t count = ::pread(descriptor, text.data(), text.size(), 0);
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return text;
}

/// Returns 0 or errno.
int writeText(int descriptor, const std::string& text) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count == static_cast<ssize_t>(text.size())) return 0;
    return count < 0 ? errno : ENOSPC;
}

/// Locks a file that others hold only while they look at it; returns 0 or errno. File systems without flock() are
/// accepted.
int acquire(int descriptor) {
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return 0;
        std::this_thread::sleep_for(kPause);
    }
    return EBUSY;
}

bool isSameFile(int descriptor, const std::filesystem::path& path) {
    struct stat opened {};
    struct stat named {};
    return ::fstat(descriptor, &opened) == 0 && ::lstat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
           opened.st_dev == named.st_dev;
}

std::string reason(int code) { return std::generic_category().message(code); }

LockHolder holderOf(const LockText& text, const struct stat& status, bool isRunningHere) {
    const std::int64_t process = text.processId();
    return {.program = text.program,
            .user = text.user.empty() ? userName(status.st_uid) : text.user,
            .host = text.host,
            .process = process,
            .since = std::chrono::system_clock::from_time_t(status.st_mtime),
            .isRunningHere = isRunningHere,
            .isThisProcess = isRunningHere && process == ::getpid(),
            .isThisProgram = !text.program.empty() && text.program == programName()};
}

}  // namespace

std::optional<LockHolder> LockFile::holdFile(const std::filesystem::path& file) const {
    const auto isSame = [&file](int descriptor) {
        struct stat opened {};
        struct stat named {};
        return ::fstat(descriptor, &opened) == 0 && ::stat(file.c_str(), &named) == 0 &&
               opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
    };
    if (m_held && isSame(m_held->descriptor())) return std::nullopt;
    m_held.reset();
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        auto opened = std::make_unique<OpenFile>(file, O_RDWR | O_NONBLOCK);
        struct stat status {};
        if (!opened->isOpen() || ::fstat(opened->descriptor(), &status) != 0 || !S_ISREG(status.st_mode)) break;
        if (::flock(opened->descriptor(), LOCK_EX | LOCK_NB) != 0) {
            if (errno == EWOULDBLOCK) return holderOfInode(status.st_ino);
            break;
        }
        if (!isSame(opened->descriptor())) continue;  // replaced meanwhile
        m_held = std::move(opened);
        break;
    }
    return std::nullopt;
}

LockFile::~LockFile() {
    if (isSameFile(m_file.descriptor(), m_path)) ::unlink(m_path.c_str());
}

/// The steps of an attempt. They return nothing if the next step has to be tried: the file exists, or does no longer.
struct LockAttempts {
    static std::optional<LockAttempt> create(const std::filesystem::path& path);
    static std::optional<LockAttempt> inspect(const std::filesystem::path& path, LockTakeover takeover, bool isLast);
};

std::optional<LockAttempt> LockAttempts::create(const std::filesystem::path& path) {
    OpenFile file(path, O_RDWR | O_CREAT | O_EXCL, 0644);
    if (!file.isOpen() && errno == EEXIST) return std::nullopt;
    if (!file.isOpen()) return LockAttempt{.reason = reason(errno)};
    int code = acquire(file.descriptor());
    if (code == 0) code = writeText(file.descriptor(), ownText());
    if (code != 0) {
        ::unlink(path.c_str());
        return LockAttempt{.reason = reason(code)};
    }
    if (!isSameFile(file.descriptor(), path)) return std::nullopt;  // taken over while it was empty
    return LockAttempt{.lock = std::shared_ptr<const LockFile>(new LockFile(path, std::move(file)))};
}

/// Looks at an existing file; removes it if it may be taken over. A file without text may be about to be written: it is
/// judged by the last attempt only.
std::optional<LockAttempt> LockAttempts::inspect(const std::filesystem::path& path, LockTakeover takeover,
                                                 bool isLast) {
    constexpr int kFlags = O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;
    int descriptor = ::open(path.c_str(), O_RDWR | kFlags);
    if (descriptor < 0 && errno == EROFS) return LockAttempt{.reason = reason(EROFS)};
    if (descriptor < 0) descriptor = ::open(path.c_str(), O_RDONLY | kFlags);
    const OpenFile file(descriptor);
    struct stat status {};
    if (::lstat(path.c_str(), &status) != 0) return std::nullopt;
    if (file.isOpen() && !isSameFile(descriptor, path)) return std::nullopt;
    const bool isReadable = file.isOpen() && S_ISREG(status.st_mode);
    const LockText text(isReadable ? readText(descriptor) : std::string());
    if (text.processId() == 0 && !isLast) return std::nullopt;  // flock() would hold up the process that creates it
    const bool isFlocked = isReadable && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    const bool isHeld = isReadable && !isFlocked && errno == EWOULDBLOCK;
    if (isFlocked && !isSameFile(descriptor, path)) return std::nullopt;

    const bool isHere = text.isOfThisMachine();
    if (isHere && isHeld && !text.hasLivingProcess() && !isLast) return std::nullopt;  // another process looks at it
    const bool isRunningHere = isHere && (isHeld || (!isFlocked && text.hasLivingProcess()));
    const bool isStale = isHere && !isRunningHere;
    if (!isStale && (takeover == LockTakeover::Stale || isRunningHere)) {
        return LockAttempt{.holder = holderOf(text, status, isRunningHere)};
    }
    if (::unlink(path.c_str()) != 0 && errno != ENOENT) return LockAttempt{.reason = reason(errno)};
    return std::nullopt;
}

LockAttempt lockFile(const std::filesystem::path& path, LockTakeover takeover) {
    for (int attempt = 1; attempt <= 2 * kAttempts; ++attempt) {
        if (std::optional<LockAttempt> created = LockAttempts::create(path)) return *std::move(created);
        const bool isLast = attempt >= kAttempts;
        if (std::optional<LockAttempt> held = LockAttempts::inspect(path, takeover, isLast)) return *std::move(held);
        if (attempt > 1) std::this_thread::sleep_for(kPause);
    }
    return {.reason = reason(EBUSY)};
}

}  // namespace rubble
