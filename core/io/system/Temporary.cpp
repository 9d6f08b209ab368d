#include "core/io/system/Temporary.h"

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

bool isTemporary(const std::string& name, const char* suffix) {
    return name.starts_with(kPrefix) && name.ends_with(suffix);
}

/// Moves the entries of a folder back beside it where their name is free. Returns false if that fails.
bool moveBack(const fs::path& leftover) {
    const Result<std::vector<fs::directory_entry>> entries = entriesOf(leftover);
    if (!entries) return false;
    for (const fs::directory_entry& entry : *entries) {
        const fs::path place = leftover.parent_path() / entry.path().filename();
        std::error_code error;
        if (fs::exists(fs::symlink_status(place, error))) continue;
        fs::rename(entry.path(), place, error);
        if (error) return false;
    }
    return true;
}

void removeLeftover(const fs::path& path) {
    const OpenFile file(path, O_RDONLY | O_NONBLOCK | O_NOFOLLOW);
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

int TemporaryFile::renameTo(const fs::path& target) {
    if (::fsync(m_file->descriptor()) != 0) return errno;
    // It stays open, and locked, until it has its name. No error is left for close() to report: all is on disk.
    if (::rename(m_path.c_str(), target.c_str()) != 0) return errno;
    m_path.clear();
    m_file.reset();
    syncFolder(target.parent_path());
    return 0;
}

Result<std::unique_ptr<TemporaryFolder>> TemporaryFolder::create(const fs::path& parent, Purpose purpose) {
    for (;;) {
        const fs::path path = unusedPath(parent, purpose == Purpose::OldContents ? kOldSuffix : kNewSuffix);
        if (::mkdir(path.c_str(), 0777) != 0) {
            if (errno == EEXIST) continue;
            return cannotDo("write into", parent, errno);
        }
        OpenFile lock(path, O_RDONLY | O_DIRECTORY);
        const int code = errno;
        if (lock.isOpen() && lockNew(lock))
            return std::unique_ptr<TemporaryFolder>(new TemporaryFolder(path, std::move(lock)));
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

void syncFolder(const fs::path& folder) {
    const OpenFile opened(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY);
    if (opened.isOpen()) static_cast<void>(::fsync(opened.descriptor()));
}

void removeLeftovers(const fs::path& folder) {
    const Result<std::vector<fs::directory_entry>> entries = entriesOf(folder);
    if (!entries) return;  // what is about to be written there will tell
    for (const fs::directory_entry& entry : *entries) {
        const std::string name = entry.path().filename().string();
        if (isTemporary(name, kNewSuffix) || isTemporary(name, kOldSuffix)) removeLeftover(entry.path());
    }
}

}  // namespace rubble
