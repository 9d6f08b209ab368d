#include "app/importer/files/MeshFiles.h"

#include "app/importer/files/AssimpValues.h"
#include "app/importer/files/MeshError.h"
#include "app/importer/files/PercentEncoding.h"
#include "app/importer/files/TextEncoding.h"
#include "core/base/MessageText.h"

#include <fcntl.h>
#include <sys/stat.h>
#ifdef __linux__
#include <linux/openat2.h>
#include <sys/syscall.h>
#endif

#include <assimp/MemoryIOWrapper.h>
#include <algorithm>
#include <array>
#include <assimp/IOStream.hpp>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>

namespace rubble {
namespace {

namespace fs = std::filesystem;

constexpr int kReading = O_RDONLY | O_CLOEXEC | O_NONBLOCK;  // a FIFO does not block
#ifdef O_PATH
constexpr int kFolder = O_PATH | O_CLOEXEC | O_DIRECTORY;
#else
constexpr int kFolder = O_RDONLY | O_CLOEXEC | O_DIRECTORY;
#endif

/// Returns the size of a regular file; nothing for anything else.
std::optional<std::size_t> fileSize(const Descriptor& file) {
    struct stat status {};
    if (::fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return static_cast<std::size_t>(status.st_size);
}

bool isLink(int folder, const fs::path& name) {
#ifdef O_PATH
    const Descriptor entry(::openat(folder, name.c_str(), O_PATH | O_CLOEXEC | O_NOFOLLOW));
    struct stat status {};
    return ::fstat(entry.number(), &status) == 0 && S_ISLNK(status.st_mode);
#else
    return false;
#endif
}

/// Opens a file below a folder one folder after the other, without following links.
Descriptor walkedTo(int folder, const fs::path& name) {
    Descriptor place;
    for (const fs::path& part : name.parent_path()) {
        const int from = place.isOpen() ? place.number() : folder;
        Descriptor next(::openat(from, part.c_str(), kFolder | O_NOFOLLOW));
        if (!next.isOpen()) {
            errno = errno == ENOTDIR && isLink(from, part) ? ELOOP : errno;
            return next;
        }
        place = std::move(next);
    }
    const int from = place.isOpen() ? place.number() : folder;
    return Descriptor(::openat(from, name.filename().c_str(), kReading | O_NOFOLLOW));
}

/// Opens a file below a folder for reading. Sets errno to EXDEV if a link is absolute or leads out of the folder, to
/// ELOOP if links form a loop, and to EMLINK if no link can be followed.
Descriptor openBeneath(int folder, const fs::path& name) {
#ifdef SYS_openat2
    const open_how how{.flags = kReading, .mode = 0, .resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS};
    const long number = ::syscall(SYS_openat2, folder, name.c_str(), &how, sizeof how);
    if (number >= 0 || (errno != ENOSYS && errno != EPERM)) return Descriptor(static_cast<int>(number));
#endif
    Descriptor file = walkedTo(folder, name);
    if (!file.isOpen() && errno == ELOOP) errno = EMLINK;
    return file;
}

std::optional<Refusal> refusalOf(int code) {
    if (code == EXDEV) return Refusal::LinkOutside;
    if (code == ELOOP) return Refusal::LinkLoop;
    return code == EMLINK ? std::optional(Refusal::AnyLink) : std::nullopt;
}

/// Whether a normal path leads out of the folder that it starts at, links aside.
bool isOutside(const fs::path& name) { return name.is_absolute() || (!name.empty() && *name.begin() == ".."); }

/// Reads a file at a position of its own, so that streams can share a descriptor.
class FileStream final : public Assimp::IOStream {
public:
    FileStream(std::shared_ptr<const Descriptor> file, std::size_t size) : m_file(std::move(file)), m_size(size) {}

    std::size_t Read(void* buffer, std::size_t size, std::size_t count) override {
        if (size == 0) return 0;
        const std::size_t most = (m_size - m_position) / size;
        const std::size_t read = readBytes(static_cast<char*>(buffer), std::min(count, most) * size);
        return read / size;
    }
    std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override {
        std::size_t position = offset;  // offsets from the end are negative and wrap around
        if (origin == aiOrigin_CUR) position += m_position;
        if (origin == aiOrigin_END) position += m_size;
        if (position > m_size) return aiReturn_FAILURE;
        m_position = position;
        return aiReturn_SUCCESS;
    }
    std::size_t Tell() const override { return m_position; }
    std::size_t FileSize() const override { return m_size; }
    void Flush() override {}

private:
    std::size_t readBytes(char* to, std::size_t count) {
        std::size_t done = 0;
        while (done < count) {
            const ssize_t read =
                ::pread(m_file->number(), to + done, count - done, static_cast<off_t>(m_position + done));
            if (read <= 0) break;
            done += static_cast<std::size_t>(read);
        }
        m_position += done;
        return done;
    }

    std::shared_ptr<const Descriptor> m_file;
    std::size_t m_size;
    std::size_t m_position = 0;
};

/// Returns whether a file of this name is text or begins with text. A binary STL file may begin with any bytes.
bool isText(const std::string& name) {
    std::string suffix = fs::path(name).extension().string();
    std::ranges::transform(suffix, suffix.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    return std::ranges::any_of(std::array{".obj", ".mtl", ".gltf", ".ply"},
                               [&](const char* text) { return suffix == text; });
}

/// Reads the first bytes of a file, at most `count`, and returns to its start.
std::string readStart(FileStream& file, std::size_t count) {
    std::string bytes(std::min(file.FileSize(), count), '\0');
    bytes.resize(file.Read(bytes.data(), 1, bytes.size()));
    file.Seek(0, aiOrigin_SET);
    return bytes;
}

/// Returns a text as UTF-8 if it is in another encoding or begins with a byte order mark; nothing otherwise.
std::optional<std::string> replacement(FileStream& file) {
    constexpr std::size_t kMark = 4;  // a byte order mark and a character
    if (!utf8Text(readStart(file, kMark))) return std::nullopt;
    return utf8Text(readStart(file, file.FileSize()));
}

/// Names a file on standard error, on one line.
void logFile(const char* what, const std::string& name) { std::fprintf(stderr, "%s %s\n", what, lineOf(name).c_str()); }

std::string contentOf(Assimp::IOStream& stream) {
    std::string bytes(stream.FileSize(), '\0');
    bytes.resize(stream.Read(bytes.data(), 1, bytes.size()));
    return bytes;
}

Assimp::IOStream* memoryStream(const std::string& bytes) {
    auto* copy = new std::uint8_t[bytes.size()];
    std::memcpy(copy, bytes.data(), bytes.size());
    return new Assimp::MemoryIOStream(copy, bytes.size(), true);  // which deletes the copy
}

}  // namespace

Result<MeshPlace> openMesh(const std::string& path) {
    const std::string name = fs::path(path).filename().string();
    const auto error = [&](const char* what) { return Error{ErrorCode::Io, quotedName(name) + " " + what}; };
    std::error_code ignored;
    const fs::path folder = fs::absolute(path, ignored).parent_path();
    MeshPlace place{name, std::make_shared<const Descriptor>(::open(path.c_str(), kReading)),
                    std::make_shared<const Descriptor>(::open(folder.c_str(), kFolder))};
    if (!place.file->isOpen() || !place.folder->isOpen()) return error("cannot be opened.");
    if (!fileSize(*place.file)) return error("is not a regular file.");
    return place;
}

std::string refusalText(const RefusedFile& file) {
    const std::string start = "refers to " + quotedName(lineOf(file.name)) + ", ";
    switch (file.reason) {
        case Refusal::Outside:
            return start + "which lies outside its folder; only files in the folder of a mesh and below are read";
        case Refusal::LinkOutside:
            return start +
                   "a link that is absolute or leads out of its folder; only relative links within the folder "
                   "of a mesh are followed";
        case Refusal::LinkLoop: return start + "a link that leads back to itself";
        case Refusal::AnyLink: return start + "a link; this system cannot follow links within a folder only";
        case Refusal::NotAFile: return start + "which is no file that can be read";
        case Refusal::TooLarge: return start + "which is too large to be read; make it smaller";
        case Refusal::Missing: break;
    }
    return start + "which does not exist";
}

bool MeshFiles::Exists(const char* name) const {
    if (name == m_place.name) return true;
    const fs::path inFolder = fs::path(name).lexically_normal();
    return !isOutside(inFolder) && fileSize(openBeneath(m_place.folder->number(), inFolder)).has_value();
}

Assimp::IOStream* MeshFiles::Open(const char* name, const char* mode) {
    if (std::string_view(mode).find_first_of("wa+") != std::string_view::npos) return nullptr;
    const std::shared_ptr<const Descriptor> file = opened(name);
    const std::optional<std::size_t> size = fileSize(*file);
    if (!size) return nullptr;
    if (m_log == FileLog::On) logFile("opened", name);
    auto stream = std::make_unique<FileStream>(file, *size);
    const std::optional<std::string> bytes = isText(name) ? replacement(*stream) : std::nullopt;
    return bytes ? memoryStream(*bytes) : stream.release();
}

void MeshFiles::Close(Assimp::IOStream* stream) { delete stream; }

std::string MeshFiles::meshContent() {
    const std::unique_ptr<Assimp::IOStream> stream(Open(m_place.name.c_str(), "rb"));
    if (!stream) throw MeshError(ErrorCode::Io, "cannot be opened");
    return contentOf(*stream);
}

std::optional<std::string> MeshFiles::content(const std::string& name, std::size_t most) {
    const std::string existing = existingName(name);
    const std::unique_ptr<Assimp::IOStream> stream(existing.empty() ? nullptr : Open(existing.c_str(), "rb"));
    if (stream && stream->FileSize() <= most) return contentOf(*stream);
    if (stream) {
        refuse(name, Refusal::TooLarge);
        return std::nullopt;
    }
    // Messages have the name as the mesh has it.
    const auto reported = std::ranges::find(m_refused, existing, &RefusedFile::name);
    if (reported != m_refused.end()) {
        reported->name = name;
    } else if (name.find("://") != std::string::npos) {
        refuse(name, Refusal::Outside);
    } else {
        const bool isThere =
            opened(existing)->isOpen() || (errno != ENOENT && errno != ENOTDIR && errno != ENAMETOOLONG);
        refuse(name, isThere && !existing.empty() ? Refusal::NotAFile : Refusal::Missing);
    }
    return std::nullopt;
}

std::string MeshFiles::existingName(const std::string& name) const {
    if (name.find('\0') != std::string::npos) return {};
    if (Exists(name.c_str())) return name;
    if (const std::optional<std::string> decoded = percentDecoded(name)) return *decoded;
    std::string forward = name;
    std::ranges::replace(forward, '\\', '/');
    return forward;
}

std::shared_ptr<const Descriptor> MeshFiles::opened(const std::string& name) {
    if (name == m_place.name) return m_place.file;
    const fs::path inFolder = fs::path(name).lexically_normal();
    const bool isRefused = isOutside(inFolder);
    Descriptor file = isRefused ? Descriptor() : openBeneath(m_place.folder->number(), inFolder);
    const int code = errno;
    if (isRefused) {
        refuse(name, Refusal::Outside);
    } else if (const std::optional<Refusal> reason = refusalOf(code); !file.isOpen() && reason) {
        refuse(name, *reason);
    }
    return std::make_shared<const Descriptor>(std::move(file));
}

void MeshFiles::refuse(const std::string& name, Refusal reason) {
    const bool isForbidden = reason != Refusal::Missing && reason != Refusal::NotAFile && reason != Refusal::TooLarge;
    if (m_log == FileLog::On && isForbidden) logFile("refused", name);
    if (std::ranges::find(m_refused, name, &RefusedFile::name) == m_refused.end()) m_refused.push_back({name, reason});
}

}  // namespace rubble
