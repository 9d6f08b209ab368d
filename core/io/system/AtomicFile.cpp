#include "core/io/system/AtomicFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <optional>
#include <system_error>

namespace rubble {
namespace {

constexpr std::size_t kMaxFileSize = std::size_t{1} << 30;  // bytes; files are read into memory whole

std::string reason(int code) { return std::generic_category().message(code); }

std::string quoted(const std::filesystem::path& path) { return "\"" + path.string() + "\""; }

Error cannotWrite(const std::filesystem::path& path, int code) {
    return {ErrorCode::Io, "Cannot write " + quoted(path) + ": " + reason(code) + "."};
}

Error cannotRead(const std::filesystem::path& path, int code) {
    const bool isMissing = code == ENOENT || code == ENOTDIR;
    return {isMissing ? ErrorCode::NotFound : ErrorCode::Io, "Cannot read " + quoted(path) + ": " + reason(code) + "."};
}

Error tooLarge(const std::filesystem::path& path) {
    return {ErrorCode::Limit, "Cannot read " + quoted(path) + ": it is larger than 1 GiB."};
}

/// Owns a file descriptor.
class OpenFile {
public:
    OpenFile(const std::filesystem::path& path, int flags, mode_t mode = 0)
        : m_descriptor(::open(path.c_str(), flags | O_CLOEXEC, mode)) {}
    ~OpenFile() {
        if (m_descriptor >= 0) ::close(m_descriptor);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    bool isOpen() const { return m_descriptor >= 0; }
    int descriptor() const { return m_descriptor; }
    /// Closes the file and returns 0 or errno: a full network disk may report its error only here.
    int close() {
        const int result = ::close(m_descriptor);
        m_descriptor = -1;
        return result == 0 ? 0 : errno;
    }

private:
    int m_descriptor;
};

/// Writes all bytes and returns 0 or errno.
int writeAll(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return 0;
}

/// Creates a file, writes `bytes` and flushes them to disk; returns 0 or errno. The default permissions are those of
/// the umask.
int createFile(const std::filesystem::path& path, std::string_view bytes, std::optional<mode_t> permissions) {
    OpenFile file(path, O_WRONLY | O_CREAT | O_EXCL, 0666);
    if (!file.isOpen()) return errno;
    if (permissions && ::fchmod(file.descriptor(), *permissions) != 0) return errno;
    if (const int code = writeAll(file.descriptor(), bytes)) return code;
    if (::fsync(file.descriptor()) != 0) return errno;
    return file.close();
}

/// Returns a path beside the target that no other writer of this or another process uses.
std::filesystem::path temporaryBeside(const std::filesystem::path& target) {
    static std::atomic<unsigned> counter{0};
    return target.parent_path() /
           (".rubble-" + std::to_string(::getpid()) + "-" + std::to_string(counter.fetch_add(1)) + ".tmp");
}

/// Flushes a directory, so that a rename in it survives a power cut. Errors are ignored: the file is complete either
/// way.
void syncDirectory(const std::filesystem::path& folder) {
    const OpenFile opened(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY);
    if (opened.isOpen()) static_cast<void>(::fsync(opened.descriptor()));
}

Status replaceFile(const std::filesystem::path& path, std::string_view bytes, std::optional<mode_t> permissions) {
    std::filesystem::path temporary = temporaryBeside(path);
    int code = createFile(temporary, bytes, permissions);
    while (code == EEXIST) {  // left by a killed process that had the same id
        temporary = temporaryBeside(path);
        code = createFile(temporary, bytes, permissions);
    }
    if (code == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) code = errno;
    if (code != 0) {
        ::unlink(temporary.c_str());
        return cannotWrite(path, code);
    }
    syncDirectory(path.parent_path());
    return success();
}

/// Devices and pipes cannot be replaced by a rename: the bytes are written to them directly.
Status writeToDevice(const std::filesystem::path& path, std::string_view bytes) {
    OpenFile file(path, O_WRONLY);
    if (!file.isOpen()) return cannotWrite(path, errno);
    if (const int code = writeAll(file.descriptor(), bytes)) return cannotWrite(path, code);
    if (const int code = file.close()) return cannotWrite(path, code);
    return success();
}

}  // namespace

Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes) {
    struct stat old {};
    if (::stat(path.c_str(), &old) != 0) return replaceFile(path, bytes, std::nullopt);
    if (S_ISDIR(old.st_mode)) return cannotWrite(path, EISDIR);
    if (!S_ISREG(old.st_mode)) return writeToDevice(path, bytes);
    if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0)
        return cannotWrite(path, errno);  // a rename would ignore the protection
    std::error_code error;
    const std::filesystem::path target =
        std::filesystem::canonical(path, error);  // replaces the target of a symbolic link
    if (error) return cannotWrite(path, error.value());
    return replaceFile(target, bytes, old.st_mode & 0777);
}

Result<std::string> readFile(const std::filesystem::path& path) {
    const OpenFile file(path, O_RDONLY);
    if (!file.isOpen()) return cannotRead(path, errno);
    struct stat status {};
    if (::fstat(file.descriptor(), &status) != 0) return cannotRead(path, errno);
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
