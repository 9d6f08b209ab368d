#include "core/io/system/Temporary.h"

#include "core/base/MessageText.h"

#include "core/io/system/FileErrors.h"
#include "core/io/system/FolderReading.h"

#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <string>
#include <system_error>

namespace rubble {

namespace fs = std::filesystem;

namespace {

constexpr const char* kPrefix = ".rubble-";
constexpr const char* kNewSuffix = ".tmp";
constexpr const char* kOldSuffix = ".old";

/// Returns a name of its own in `folder`: a name that is taken is as likely as two equal random numbers of 64 bits.
fs::path unusedPath(const fs::path& folder, const char* suffix) {
    std::uint64_t random = 0;
    static_cast<void>(!::getrandom(&random, sizeof random, 0));  // without random bytes, O_EXCL finds the taken name
    char name[64];
    std::snprintf(name, sizeof name, "%s%d-%016llx%s", kPrefix, static_cast<int>(::getpid()),
                  static_cast<unsigned long long>(random), suffix);
    return folder / name;
}

/// Locks a new file or folder. Returns false if a process that looked for leftovers was faster.
bool lockNew(const OpenFile& file) {
    if (::flock(file.descriptor(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
    struct stat status {};
    return ::fstat(file.descriptor(), &status) == 0 && status.st_nlink > 0;
}

/// Whether a name is one that unusedPath() gives: users may have hidden files of similar names.
bool isTemporary(const std::string& name, std::string_view suffix) {
    constexpr std::size_t kRandomDigits = 16;
    constexpr const char* kDigits = "0123456789abcdef";
    const std::string_view prefix = kPrefix;
    if (!name.starts_with(prefix) || !name.ends_with(suffix) || name.size() < prefix.size() + suffix.size())
        return false;
    const std::string stem = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
    const std::size_t dash = stem.find_first_not_of("0123456789");
    return dash != 0 && dash != std::string::npos && stem[dash] == '-' && stem.size() == dash + 1 + kRandomDigits &&
           stem.find_first_not_of(kDigits, dash + 1) == std::string::npos;
}

/// The path of the other folder of a replacement: of the old contents for the new ones.
fs::path oldContentsOf(const fs::path& replacement) { return fs::path(replacement).replace_extension(kOldSuffix); }
fs::path replacementOf(const fs::path& oldContents) { return fs::path(oldContents).replace_extension(kNewSuffix); }

/// Moves the entries of a folder back beside it. Returns whether the rest can be removed: entries whose name is taken
/// are kept unless it was taken by their replacement, which then is no longer in its folder.
bool moveBack(const fs::path& leftover) {
    const Result<std::vector<fs::directory_entry>> entries = entriesOf(leftover);
    if (!entries) return false;
    std::error_code error;
    const bool isReplaced = !fs::exists(fs::symlink_status(replacementOf(leftover), error));
    bool isEmptied = true;
    for (const fs::directory_entry& entry : *entries) {
        const fs::path place = leftover.parent_path() / entry.path().filename();
        const bool isTaken = fs::exists(fs::symlink_status(place, error));
        if (!isTaken) fs::rename(entry.path(), place, error);
        if (isTaken ? !isReplaced : static_cast<bool>(error)) isEmptied = false;
    }
    return isEmptied;
}

void removeLeftover(const fs::path& path) {
    constexpr int kFlags = O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW;
    int descriptor = ::open(path.c_str(), O_RDWR | kFlags);  // NFS locks no file that is open only for reading
    if (descriptor < 0) descriptor = ::open(path.c_str(), O_RDONLY | kFlags);
    const OpenFile file(descriptor);
    struct stat status {};
    if (!file.isOpen() || ::fstat(file.descriptor(), &status) != 0 || status.st_uid != ::geteuid()) return;
    if (!S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) return;
    if (::flock(file.descriptor(), LOCK_EX | LOCK_NB) != 0) return;
    if (path.native().ends_with(kOldSuffix) && !moveBack(path)) return;
    std::error_code ignored;
    fs::remove_all(path, ignored);
}

}  // namespace

int TemporaryFile::create(const fs::path& folder, mode_t permissions) {
    for (;;) {
        const fs::path path = unusedPath(folder, kNewSuffix);
        auto file = std::make_unique<OpenFile>(path, O_RDWR | O_CREAT | O_EXCL, permissions);
        if (!file->isOpen() && errno == EEXIST) continue;
        if (!file->isOpen()) return errno;
        if (!lockNew(*file)) continue;
        m_path = path;
        m_file = std::move(file);
        return 0;
    }
}

TemporaryFile::~TemporaryFile() {
    if (!m_path.empty()) ::unlink(m_path.c_str());
}

Status TemporaryFile::renameTo(const fs::path& target, const fs::path& path) {
    if (::fsync(m_file->descriptor()) != 0) return cannotWrite(path, errno);
    // It stays open, and locked, until it has its name. No error is left for close() to report: all is on disk.
    if (::rename(m_path.c_str(), target.c_str()) != 0) return cannotWrite(path, errno);
    m_path.clear();
    m_file.reset();
    return flushRenamed(target, path);
}

Result<std::unique_ptr<TemporaryFolder>> TemporaryFolder::create(const fs::path& parent) {
    return create(parent, [&] { return unusedPath(parent, kNewSuffix); });
}

Result<std::unique_ptr<TemporaryFolder>> TemporaryFolder::createForOldContents(const TemporaryFolder& replacement) {
    return create(replacement.path().parent_path(), [&] { return oldContentsOf(replacement.path()); });
}

Result<std::unique_ptr<TemporaryFolder>> TemporaryFolder::create(const fs::path& parent,
                                                                 const std::function<fs::path()>& pathOfAttempt) {
    for (;;) {
        const fs::path path = pathOfAttempt();
        if (::mkdir(path.c_str(), 0777) != 0) {  // empty for now: others see nothing before fchmod()
            if (errno == EEXIST) continue;
            return cannotDo("write into", parent, errno);
        }
        OpenFile lock(path, O_RDONLY | O_DIRECTORY);
        const int code = errno;
        struct stat status {};
        if (lock.isOpen() && lockNew(lock) && ::fstat(lock.descriptor(), &status) == 0) {
            std::unique_ptr<TemporaryFolder> folder(new TemporaryFolder(path, std::move(lock), status.st_mode));
            if (::fchmod(folder->descriptor(), 0700) != 0) return cannotDo("write into", parent, errno);
            return folder;
        }
        if (lock.isOpen() || code == ENOENT) continue;  // removed as a leftover
        ::rmdir(path.c_str());
        return cannotDo("write into", parent, code);
    }
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;  // the next removeLeftovers() tries again
    if (!m_path.empty()) fs::remove_all(m_path, ignored);
}

int writeAll(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return 0;
}

int inheritFrom(const struct stat& old, int created) {
    struct stat status {};
    if (::fstat(created, &status) != 0) return errno;
    const bool isOwned = status.st_uid == old.st_uid || ::fchown(created, old.st_uid, old.st_gid) == 0;
    const bool hasGroup = status.st_gid == old.st_gid || (isOwned && status.st_uid != old.st_uid);
    if (!hasGroup && ::fchown(created, static_cast<uid_t>(-1), old.st_gid) != 0) return errno;
    return ::fchmod(created, old.st_mode & 07777) == 0 ? 0 : errno;
}

int syncFolder(const fs::path& folder) {
    const OpenFile opened(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY);
    if (!opened.isOpen()) return errno == EACCES ? 0 : errno;
    if (::fsync(opened.descriptor()) == 0) return 0;
    return errno == EINVAL || errno == ENOTSUP || errno == ENOSYS ? 0 : errno;
}

Status flushRenamed(const fs::path& target, const fs::path& path) {
    const int code = syncFolder(target.parent_path());
    if (code == 0) return success();
    return Error{ErrorCode::Io, quotedPath(path) + " was written, but its folder cannot be flushed to disk (" +
                                    std::generic_category().message(code) +
                                    "): a power cut may undo it. Write it again or elsewhere."};
}

bool isTemporaryName(const std::string& name) { return isTemporary(name, kNewSuffix) || isTemporary(name, kOldSuffix); }

void removeLeftovers(const fs::path& folder) {
    const Result<std::vector<fs::directory_entry>> entries = entriesOf(folder);
    if (!entries) return;  // writing there will report the fault
    for (const fs::directory_entry& entry : *entries) {
        const std::string name = entry.path().filename().string();
        if (isTemporary(name, kOldSuffix)) removeLeftover(entry.path());
    }
    for (const fs::directory_entry& entry : *entries) {
        std::error_code error;  // while there are old contents, their replacement reports what happened to them
        const bool isNeeded = fs::exists(fs::symlink_status(oldContentsOf(entry.path()), error));
        if (isTemporary(entry.path().filename().string(), kNewSuffix) && !isNeeded) removeLeftover(entry.path());
    }
}

}  // namespace rubble
