#include "core/io/ExportFolder.h"

#include "core/io/AtomicFile.h"
#include "core/io/JsonReading.h"
#include "core/io/JsonText.h"
#include "core/io/MadeFolders.h"
#include "core/io/NumberText.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <optional>
#include <system_error>
#include <vector>

namespace rubble {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFormat = "rubble-manifest";
constexpr std::uint32_t kVersion = 1;

struct ManifestEntry {
    std::string name;
    std::uint64_t size = 0;  // bytes
    std::string hash;
    bool operator==(const ManifestEntry&) const = default;
};

struct Manifest {
    std::string source;
    std::vector<ManifestEntry> files;
};

std::string inQuotes(const fs::path& path) { return "\"" + path.string() + "\""; }

Error cannot(const std::string& what, const fs::path& path, const std::error_code& reason) {
    return {ErrorCode::Io, "Cannot " + what + " " + inQuotes(path) + ": " + reason.message() + "."};
}

std::string manifestJson(const Manifest& manifest) {
    std::string json = std::string("{\n  \"format\": \"") + kFormat + "\",\n  \"version\": ";
    appendNumber(json, kVersion);
    json += ",\n  \"source\": \"" + manifest.source + "\",\n  \"files\": [";
    for (const ManifestEntry& file : manifest.files) {
        json += &file == manifest.files.data() ? "\n    {\"name\": " : ",\n    {\"name\": ";
        appendJsonText(json, file.name);
        json += ", \"size\": " + std::to_string(file.size) + ", \"hash\": \"" + file.hash + "\"}";
    }
    return json + "\n  ]\n}\n";
}

/// The manifest of a folder, where there is one that this version can read.
std::optional<Manifest> manifestOf(const fs::path& folder) {
    const Result<std::string> text = readFile(folder / kManifestName);
    if (!text) return std::nullopt;
    Result<JsonDocument> document = JsonDocument::parse(*text);
    if (!document) return std::nullopt;
    const JsonValue root = document->root();
    root.requireObject({"format", "version", "source", "files"});
    if (root["format"].text() != kFormat || root["version"].index() != kVersion) return std::nullopt;
    Manifest manifest;
    manifest.source = root["source"].text();
    for (const JsonValue file : root["files"].elements()) {
        file.requireObject({"name", "size", "hash"});
        manifest.files.push_back({file["name"].text(), file["size"].wholeNumber(), file["hash"].text()});
    }
    if (document->fault()) return std::nullopt;
    return manifest;
}

ManifestEntry entryOf(const std::string& name, std::string_view bytes) {
    return {name, bytes.size(), contentHash(bytes).hex()};
}

/// Something in the folder that its manifest does not list; nothing where all is of an export, or where it is empty.
Result<std::optional<std::string>> strangerIn(const fs::path& folder) {
    const std::optional<Manifest> manifest = manifestOf(folder);
    std::error_code fault;
    std::vector<std::string> strangers;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, fault)) {
        const std::string name = entry.path().filename().string();
        const auto isListed = [&](const ManifestEntry& file) { return file.name == name; };
        const bool isOurs = manifest && (name == kManifestName || std::ranges::any_of(manifest->files, isListed));
        if (!isOurs || entry.is_directory()) strangers.push_back(name);
    }
    if (fault) return cannot("read", folder, fault);
    if (strangers.empty()) return std::optional<std::string>();
    return std::optional(*std::ranges::min_element(strangers));
}

/// A hidden folder that is removed with all it holds when it is let go.
class HiddenFolder {
public:
    /// Gives it a name beside `target` that nobody has.
    static Result<std::unique_ptr<HiddenFolder>> create(const fs::path& target, const char* purpose) {
        const std::string stem = "." + target.filename().string() + "." + purpose + "-";
        for (int number = 0;; ++number) {
            std::error_code fault;
            const fs::path path = target.parent_path() / (stem + std::to_string(number));
            if (fs::create_directory(path, fault)) return std::make_unique<HiddenFolder>(path);
            if (fault && fault != std::errc::file_exists) return cannot("write into", target.parent_path(), fault);
        }
    }
    explicit HiddenFolder(fs::path path) : m_path(std::move(path)) {}
    ~HiddenFolder() {
        std::error_code ignored;  // it is hidden, and says by its name what it was
        fs::remove_all(m_path, ignored);
    }
    HiddenFolder(const HiddenFolder&) = delete;
    HiddenFolder& operator=(const HiddenFolder&) = delete;
    const fs::path& path() const { return m_path; }

private:
    fs::path m_path;
};

Status writeNewFile(const fs::path& path, std::string_view bytes) {
    errno = 0;
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) return cannot("write", path, {errno != 0 ? errno : EIO, std::generic_category()});
    return success();
}

/// Renames `fresh` to `folder`, an earlier `folder` having been moved into `aside`; on a fault that is moved back.
Status swapIn(const fs::path& fresh, const fs::path& folder, const fs::path& aside) {
    std::error_code ignored;
    std::error_code fault;
    const fs::path earlier = aside / folder.filename();
    const bool hadEarlier = fs::exists(fs::symlink_status(folder, ignored));
    if (hadEarlier) fs::rename(folder, earlier, fault);
    if (fault) return cannot("replace", folder, fault);
    fs::rename(fresh, folder, fault);
    if (!fault) return success();
    if (hadEarlier) fs::rename(earlier, folder, ignored);
    return cannot("write", folder, fault);
}

Status checkReplaceable(const fs::path& folder) {
    std::error_code ignored;
    if (!fs::exists(folder, ignored)) return success();
    if (!fs::is_directory(folder, ignored)) {
        return Error{ErrorCode::BadInput,
                     inQuotes(folder) + " is a file, where a folder has to go; move it away first."};
    }
    const Result<std::optional<std::string>> stranger = strangerIn(folder);
    if (!stranger) return stranger.error();
    if (!*stranger) return success();
    return Error{ErrorCode::BadInput, "The folder " + inQuotes(folder) + " holds " + inQuotes(**stranger) +
                                          ", which no export wrote; move it away first, or export elsewhere."};
}

}  // namespace

bool isExportOf(const fs::path& folder, const ContentHash& source) {
    const std::optional<Manifest> manifest = manifestOf(folder);
    if (!manifest || manifest->source != source.hex()) return false;
    return std::ranges::all_of(manifest->files, [&](const ManifestEntry& file) {
        const Result<std::string> bytes = readFile(folder / file.name);
        return bytes && entryOf(file.name, *bytes) == file;
    });
}

std::optional<std::string> verifyExportFolder(const fs::path& folder) {
    const std::optional<Manifest> manifest = manifestOf(folder);
    if (!manifest) return "The folder " + inQuotes(folder) + " has no " + kManifestName + " that can be read.";
    for (const ManifestEntry& file : manifest->files) {
        const Result<std::string> bytes = readFile(folder / file.name);
        if (!bytes) return bytes.error().message;
        if (entryOf(file.name, *bytes) != file) return inQuotes(folder / file.name) + " is not as it was exported.";
    }
    const Result<std::optional<std::string>> stranger = strangerIn(folder);
    if (!stranger) return stranger.error().message;
    if (!*stranger) return std::nullopt;
    return "The folder " + inQuotes(folder) + " holds " + inQuotes(**stranger) + ", which no export wrote.";
}

Status writeExportFolder(const fs::path& folder, const ContentHash& source, std::span<const ExportFile> files,
                         const TaskContext& task) {
    if (const Status free = checkReplaceable(folder); !free) return free;
    MadeFolders above;
    if (folder.has_parent_path()) {
        if (const Status made = above.make(folder.parent_path()); !made) return made;
    }
    const auto fresh = HiddenFolder::create(folder, "partial");
    if (!fresh) return fresh.error();

    Manifest manifest{source.hex(), {}};
    for (const ExportFile& file : files) {
        if (task.isCancelled()) return TaskContext::cancelled();
        if (const Status written = writeNewFile((*fresh)->path() / file.name, file.bytes); !written) return written;
        manifest.files.push_back(entryOf(file.name, file.bytes));
    }
    const Status listed = writeNewFile((*fresh)->path() / kManifestName, manifestJson(manifest));
    if (!listed) return listed;
    const auto aside = HiddenFolder::create(folder, "replaced");
    if (!aside) return aside.error();
    return swapIn((*fresh)->path(), folder, (*aside)->path());
}

std::string safeFileName(const std::string& name) {
    std::string safe = name;
    for (char& letter : safe) {
        const auto code = static_cast<unsigned char>(letter);
        const bool isAlphanumeric = (code >= '0' && code <= '9') || ((code | 32) >= 'a' && (code | 32) <= 'z');
        if (!isAlphanumeric && code < 0x80 && std::string_view("-_. ").find(letter) == std::string_view::npos)
            letter = '_';
    }
    for (const std::size_t end : {std::size_t{0}, safe.size() - 1}) {
        if (!safe.empty() && (safe[end] == '.' || safe[end] == ' ')) safe[end] = '_';
    }
    return safe.empty() ? "_" : safe;
}

}  // namespace rubble
