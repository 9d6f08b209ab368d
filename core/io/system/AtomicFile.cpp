#include "core/io/system/AtomicFile.h"

#include "core/io/system/FileErrors.h"
#include "core/io/system/Temporary.h"

#include <sys/stat.h>
#include <sys/xattr.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <system_error>

namespace rubble {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxFileSize = std::size_t{1} << 30;  // bytes; files are read into memory whole

Error tooLarge(const fs::path& path) {
    return {ErrorCode::Limit, "Cannot read \"" + path.string() + "\": it is larger than 1 GiB."};
}

/// Devices and pipes cannot be replaced by a rename: the bytes are written to them directly.
Status writeToDevice(const fs::path& path, std::string_view bytes) {
    OpenFile file(path, O_WRONLY);
    if (!file.isOpen()) return cannotWrite(path, errno);
    if (const int code = writeAll(file.descriptor(), bytes)) return cannotWrite(path, code);
    if (file.close() != 0) return cannotWrite(path, errno);
    return success();
}

/// Writes a file that does not exist yet and flushes it to disk; returns 0 or errno.
int writeNewFile(const fs::path& path, std::string_view bytes, mode_t permissions) {
    OpenFile file(path, O_WRONLY | O_CREAT | O_EXCL, permissions);
    if (!file.isOpen()) return errno;
    if (const int code = writeAll(file.descriptor(), bytes)) return code;
    return ::fsync(file.descriptor()) != 0 || file.close() != 0 ? errno : 0;
}

/// Replaces the bytes of a file and flushes them to disk; returns 0 or errno.
int overwriteBytes(const fs::path& path, std::string_view bytes) {
    OpenFile file(path, O_WRONLY);
    if (!file.isOpen()) return errno;
    if (const int code = writeAll(file.descriptor(), bytes)) return code;
    if (::ftruncate(file.descriptor(), static_cast<off_t>(bytes.size())) != 0) return errno;
    return ::fsync(file.descriptor()) != 0 || file.close() != 0 ? errno : 0;
}

/// Writes into the existing file, after a copy of it beside it, which is removed at the end.
Status writeInPlace(const fs::path& path, std::string_view bytes) {
    const Result<std::string> old = readFile(path);
    if (!old) return old.error();
    const fs::path copy = copyBeforeSave(path);
    if (const int code = writeNewFile(copy, *old, 0600)) {
        if (code != EEXIST) ::unlink(copy.c_str());
        if (code != EEXIST) return cannotWrite(path, code);
        return Error{ErrorCode::Io, "Cannot write \"" + path.string() + "\": an interrupted save left \"" +
                                        copy.string() + "\". Compare the two and move or delete it."};
    }
    syncFolder(path.parent_path());
    const int code = overwriteBytes(path, bytes);
    const bool isWhole = code == 0 || overwriteBytes(path, *old) == 0;
    if (isWhole) ::unlink(copy.c_str());
    if (code == 0) return success();
    Error error = cannotWrite(path, code);
    if (!isWhole) error.message += " Its previous contents are in \"" + copy.string() + "\".";
    return error;
}

/// Replaces `target` by a new file of the same owner and permissions, as `old` has them, or creates it. `path` is the
/// name in errors.
Status replaceFile(const fs::path& path, const fs::path& target, std::string_view bytes,
                   const std::optional<struct stat>& old) {
    TemporaryFile temporary;
    if (const int code = temporary.create(target.parent_path(), old ? 0600 : 0666)) return cannotWrite(path, code);
    struct stat created {};
    if (old && ::fstat(temporary.descriptor(), &created) == 0) {
        const bool hasOwner = created.st_uid == old->st_uid && created.st_gid == old->st_gid;
        if (!hasOwner && ::fchown(temporary.descriptor(), old->st_uid, old->st_gid) != 0)
            return writeInPlace(target, bytes);
        if (::fchmod(temporary.descriptor(), old->st_mode & 0777) != 0) return cannotWrite(path, errno);
    }
    int code = writeAll(temporary.descriptor(), bytes);
    if (code == 0) code = temporary.renameTo(target);
    if (code != 0) return cannotWrite(path, code);
    return success();
}

bool hasAccessList(const fs::path& path) { return ::getxattr(path.c_str(), "system.posix_acl_access", nullptr, 0) > 0; }

/// Returns the end of a sentence about a path that is not a regular file.
const char* kindOf(mode_t mode) {
    if (S_ISFIFO(mode)) return "it is a pipe, not a file";
    if (S_ISSOCK(mode)) return "it is a socket, not a file";
    return "it is a device, not a file";
}

}  // namespace

fs::path linkTarget(fs::path path) {
    constexpr int kMaxLinks = 40;  // as Linux follows
    std::error_code error;
    for (int count = 0; count < kMaxLinks && fs::is_symlink(path, error); ++count)
        path = path.parent_path() / fs::read_symlink(path, error);
    return path;
}

fs::path copyBeforeSave(const fs::path& path) { return path.native() + ".before-save"; }

Status writeFileAtomically(const fs::path& path, std::string_view bytes) {
    struct stat old {};
    std::error_code error;
    if (::stat(path.c_str(), &old) != 0) {
        if (errno != ENOENT) return cannotWrite(path, errno);
        return replaceFile(path, linkTarget(path), bytes, std::nullopt);
    }
    if (S_ISDIR(old.st_mode)) return cannotWrite(path, EISDIR);
    if (!S_ISREG(old.st_mode)) return writeToDevice(path, bytes);
    if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0)
        return cannotWrite(path, errno);                 // a rename would ignore the protection
    const fs::path target = fs::canonical(path, error);  // replaces the target of a symbolic link
    if (error) return cannotWrite(path, error.value());
    if (old.st_nlink > 1 || hasAccessList(target)) return writeInPlace(target, bytes);
    return replaceFile(path, target, bytes, old);
}

Result<std::string> readFile(const fs::path& path) {
    const OpenFile file(path, O_RDONLY | O_NONBLOCK);  // opening a pipe would wait for a writer
    if (!file.isOpen()) return cannotRead(path, errno);
    struct stat status {};
    if (::fstat(file.descriptor(), &status) != 0) return cannotRead(path, errno);
    if (S_ISDIR(status.st_mode)) return cannotRead(path, EISDIR);
    if (!S_ISREG(status.st_mode))
        return Error{ErrorCode::Io, "Cannot read \"" + path.string() + "\": " + kindOf(status.st_mode) + "."};
    if (status.st_size > static_cast<off_t>(kMaxFileSize)) return tooLarge(path);
    std::string bytes(status.st_size > 0 ? static_cast<std::size_t>(status.st_size) + 1 : 65536, '\0');
    std::size_t used = 0;
    for (;;) {
        const ssize_t count = ::read(file.descriptor(), bytes.data() + used, bytes.size() - used);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return cannotRead(path, errno);
        if (count == 0) break;
        used += static_cast<std::size_t>(count);
        if (used > kMaxFileSize) return tooLarge(path);
        if (used == bytes.size()) bytes.resize(std::min(2 * used, kMaxFileSize + 1));
    }
    bytes.resize(used);
    return bytes;
}

}  // namespace rubble
