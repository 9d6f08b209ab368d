#include "core/io/system/AtomicFile.h"

#include "core/base/MessageText.h"
#include "core/io/system/FileErrors.h"
#include "core/io/system/FileName.h"
#include "core/io/system/OpenFile.h"
#include "core/io/system/Temporary.h"

#include <sys/stat.h>
#include <sys/xattr.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <system_error>

namespace rubble {

namespace fs = std::filesystem;

namespace {

/// The first byte of a file that is being written in place. No format of ours begins with it.
constexpr char kInterrupted = '\0';
constexpr std::size_t kMaxFileSize = std::size_t{1} << 30;  // bytes; files are read into memory whole

Error tooLarge(const fs::path& path) {
    return {ErrorCode::Limit, "Cannot read " + quotedPath(path) + ": it is larger than 1 GiB."};
}

/// Devices and pipes cannot be replaced by a rename: the bytes are written to them directly.
Status writeToDevice(const fs::path& path, std::string_view bytes) {
    OpenFile file(path, O_WRONLY);
    if (!file.isOpen()) return cannotWrite(path, errno);
    if (const int code = writeAll(file.descriptor(), bytes)) return cannotWrite(path, code);
    if (file.close() != 0) return cannotWrite(path, errno);
    return success();
}

/// Writes one byte at the start of a file and flushes all that was written to disk; returns 0 or errno.
int setFirstByte(const OpenFile& file, char byte) {
    const ssize_t count = ::pwrite(file.descriptor(), &byte, 1, 0);
    if (count != 1) return count < 0 ? errno : EIO;
    return ::fsync(file.descriptor()) == 0 ? 0 : errno;
}

/// Replaces the bytes of a file and flushes them to disk; returns 0 or errno. Until all others are on the disk, the
/// first one is kInterrupted.
int overwriteBytes(const fs::path& path, std::string_view bytes) {
    OpenFile file(path, O_WRONLY | O_NONBLOCK);
    if (!file.isOpen()) return errno;
    if (const int code = setFirstByte(file, kInterrupted)) return code;
    if (::lseek(file.descriptor(), 1, SEEK_SET) != 1) return errno;
    if (const int code = writeAll(file.descriptor(), bytes.substr(std::min<std::size_t>(1, bytes.size())))) return code;
    if (::ftruncate(file.descriptor(), static_cast<off_t>(bytes.size())) != 0) return errno;
    if (::fsync(file.descriptor()) != 0) return errno;
    if (!bytes.empty()) {
        if (const int code = setFirstByte(file, bytes.front())) return code;
    }
    return file.close() == 0 ? 0 : errno;
}

/// Writes a copy, whole or not at all, and flushes it to disk. A copy that is there is replaced: it is older than the
/// file, which is whole.
Status writeCopy(const fs::path& copy, std::string_view bytes) {
    TemporaryFile temporary;
    if (const int code = temporary.create(copy.parent_path(), 0600)) return cannotWrite(copy, code);
    if (const int code = writeAll(temporary.descriptor(), bytes)) return cannotWrite(copy, code);
    return temporary.renameTo(copy, copy);
}

/// Writes into the existing file, after a copy of it beside it, which is removed at the end.
Status writeInPlace(const fs::path& path, std::string_view bytes) {
    const Result<std::string> old = readFile(path);
    if (!old) return old.error();
    if (isInterruptedSave(*old)) return withPath("Cannot write", path, {ErrorCode::Io, interruptedSaveText(path)});
    const fs::path copy = copyBeforeSave(path);
    if (const Status copied = writeCopy(copy, *old); !copied) {
        ::unlink(copy.c_str());
        return copied;
    }
    const int code = overwriteBytes(path, bytes);
    const bool isWhole = code == 0 || overwriteBytes(path, *old) == 0;
    if (isWhole) ::unlink(copy.c_str());
    if (code == 0) return success();
    Error error = cannotWrite(path, code);
    if (!isWhole) error.message += " Its previous contents are in " + quotedPath(copy) + ".";
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
    if (const int code = writeAll(temporary.descriptor(), bytes)) return cannotWrite(path, code);
    return temporary.renameTo(target, path);
}

bool hasAccessList(const fs::path& path) { return ::getxattr(path.c_str(), "system.posix_acl_access", nullptr, 0) > 0; }

/// The error of what cannot be done with a path that is not a regular file.
Error notAFile(const char* verb, const fs::path& path, mode_t mode) {
    const char* kind = S_ISFIFO(mode) ? "pipe" : S_ISSOCK(mode) ? "socket" : "device";
    return {ErrorCode::Io,
            std::string("Cannot ") + verb + " " + quotedPath(path) + ": it is a " + kind + ", not a file."};
}

/// Opens a file for reading, unless it is a folder, a pipe or a device, or a link that is refused.
Result<OpenFile> openRegularFile(const fs::path& path, Links links, struct stat& status) {
    const int flags = links == Links::Refused ? O_NOFOLLOW : 0;
    OpenFile file(path, O_RDONLY | O_NONBLOCK | flags);  // opening a pipe would wait for a writer
    if (!file.isOpen() && errno == ELOOP && links == Links::Refused)
        return Error{ErrorCode::Io, quotedPath(path) + " is a link, which is not followed here; replace it by a file."};
    if (!file.isOpen() || ::fstat(file.descriptor(), &status) != 0) return cannotRead(path, errno);
    if (S_ISDIR(status.st_mode)) return cannotRead(path, EISDIR);
    if (!S_ISREG(status.st_mode)) return notAFile("read", path, status.st_mode);
    if (status.st_size > static_cast<off_t>(kMaxFileSize)) return tooLarge(path);
    return file;
}

/// read() that goes on after signals.
ssize_t readBlock(const OpenFile& file, char* at, std::size_t size) {
    for (;;) {
        const ssize_t count = ::read(file.descriptor(), at, size);
        if (count >= 0 || errno != EINTR) return count;
    }
}

}  // namespace

fs::path linkTarget(fs::path path) {
    constexpr int kMaxLinks = 40;  // as Linux follows
    std::error_code error;
    for (int count = 0; count < kMaxLinks && fs::is_symlink(path, error); ++count)
        path = path.parent_path() / fs::read_symlink(path, error);
    return path;
}

fs::path copyBeforeSave(const fs::path& path) {
    std::error_code error;
    const fs::path target = fs::canonical(path, error);
    const fs::path& file = error ? path : target;
    return file.parent_path() / fittingFileName("", file.filename().string(), ".before-save");
}

bool isInterruptedSave(std::string_view bytes) { return bytes.starts_with(kInterrupted); }

std::string interruptedSaveText(const fs::path& path) {
    std::error_code ignored;
    const fs::path copy = copyBeforeSave(path);
    if (fs::exists(copy, ignored))
        return "Saving it was interrupted; " + quotedPath(copy) +
               " is the file as it was before. Move it over the damaged one.";
    return "Saving it was interrupted, perhaps by another name of the file: look beside its hard links for the file as "
           "it was before, whose name ends in \".before-save\", and move that over the damaged one.";
}

Status writeFileOrStream(const fs::path& path, std::string_view bytes) {
    struct stat status {};
    const bool isFile = ::stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode) || S_ISDIR(status.st_mode);
    return isFile ? writeFileAtomically(path, bytes) : writeToDevice(path, bytes);
}

Status writeFileAtomically(const fs::path& path, std::string_view bytes, Leftovers leftovers) {
    struct stat old {};
    std::error_code error;
    if (leftovers == Leftovers::Removed) removeLeftovers(linkTarget(path).parent_path());
    if (::stat(path.c_str(), &old) != 0) {
        if (errno != ENOENT) return cannotWrite(path, errno);
        return replaceFile(path, linkTarget(path), bytes, std::nullopt);
    }
    if (S_ISDIR(old.st_mode)) return cannotWrite(path, EISDIR);
    if (!S_ISREG(old.st_mode)) return notAFile("write", path, old.st_mode);
    if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0)
        return cannotWrite(path, errno);                 // a rename would ignore the protection
    const fs::path target = fs::canonical(path, error);  // replaces the target of a symbolic link
    if (error) return cannotWrite(path, error.value());
    if (old.st_nlink > 1 || hasAccessList(target)) return writeInPlace(target, bytes);
    return replaceFile(path, target, bytes, old);
}

Result<std::string> readFile(const fs::path& path, Links links) {
    struct stat status {};
    const Result<OpenFile> file = openRegularFile(path, links, status);
    if (!file) return file.error();
    std::string bytes(status.st_size > 0 ? static_cast<std::size_t>(status.st_size) + 1 : 65536, '\0');
    std::size_t used = 0;
    for (;;) {
        const ssize_t count = readBlock(*file, bytes.data() + used, bytes.size() - used);
        if (count < 0) return cannotRead(path, errno);
        if (count == 0) break;
        used += static_cast<std::size_t>(count);
        if (used > kMaxFileSize) return tooLarge(path);
        if (used == bytes.size()) bytes.resize(std::min(2 * used, kMaxFileSize + 1));
    }
    bytes.resize(used);
    return bytes;
}

Result<FileHash> hashOfFile(const fs::path& path, Links links) {
    struct stat status {};
    const Result<OpenFile> file = openRegularFile(path, links, status);
    if (!file) return file.error();
    Hasher hasher;
    FileHash result;
    std::array<char, 65536> block;
    for (;;) {
        const ssize_t count = readBlock(*file, block.data(), block.size());
        if (count < 0) return cannotRead(path, errno);
        if (count == 0) break;
        hasher.add(std::string_view(block.data(), static_cast<std::size_t>(count)));
        result.size += static_cast<std::uint64_t>(count);
    }
    result.hash = hasher.digest();
    return result;
}

}  // namespace rubble
