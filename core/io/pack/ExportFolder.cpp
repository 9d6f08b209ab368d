#include "core/io/pack/ExportFolder.h"

#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/CreatedDirectories.h"

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
    JsonWriter json;
    json.openObject();
    json.text("format", kFormat);
    json.wholeNumber("version", std::uint64_t{kVersion});
    json.text("source", manifest.source);
    json.openArray("files");
    for (const ManifestEntry& file : manifest.files) {
        json.openObject({}, JsonLayout::Inline);
        json.text("name", file.name);
        json.wholeNumber("size", file.size);
        json.text("hash", file.hash);
        json.close();
    }
    json.close();
    json.close();
    return std::move(json).finished();
}

/// Returns the manifest of a folder, if there is one that this version can read.
std::optional<Manifest> readManifest(const fs::path& folder) {
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
    if (document->firstError()) return std::nullopt;
    return manifest;
}

ManifestEntry entryOf(const std::string& name, std::string_view bytes) {
    return {name, bytes.size(), contentHash(bytes).hex()};
}

/// Returns the name of a file in the folder that its manifest does not list, if there is one.
Result<std::optional<std::string>> findUnexpectedFile(const fs::path& folder) {
    const std::optional<Manifest> manifest = readManifest(folder);
    std::error_code error;
    std::vector<std::string> unexpected;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        const auto isListed = [&](const ManifestEntry& file) { return file.name == name; };
        const bool isExpected = manifest && (name == kManifestName || std::ranges::any_of(manifest->files, isListed));
        if (!isExpected || entry.is_directory()) unexpected.push_back(name);
    }
    if (error) return cannot("read", folder, error);
    if (unexpected.empty()) return std::optional<std::string>();
    return std::optional(*std::ranges::min_element(unexpected));
}

/// A hidden folder that is removed with its contents by the destructor.
class HiddenFolder {
public:
    /// Creates a folder with an unused name beside `target`.
    static Result<std::unique_ptr<HiddenFolder>> create(const fs::path& target, const char* purpose) {
        const std::string stem = "." + target.filename().string() + "." + purpose + "-";
        for (int number = 0;; ++number) {
            std::error_code error;
            const fs::path path = target.parent_path() / (stem + std::to_string(number));
            if (fs::create_directory(path, error)) return std::make_unique<HiddenFolder>(path);
            if (error && error != std::errc::file_exists) return cannot("write into", target.parent_path(), error);
        }
    }
    explicit HiddenFolder(fs::path path) : m_path(std::move(path)) {}
    ~HiddenFolder() {
        std::error_code ignored;  // its name says what a leftover is
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

/// Renames `partial` to `folder`, after moving an existing `folder` into `backup`; moves that back on an error.
Status replaceFolder(const fs::path& partial, const fs::path& folder, const fs::path& backup) {
    std::error_code ignored;
    std::error_code error;
    const fs::path earlier = backup / folder.filename();
    const bool hadEarlier = fs::exists(fs::symlink_status(folder, ignored));
    if (hadEarlier) fs::rename(folder, earlier, error);
    if (error) return cannot("replace", folder, error);
    fs::rename(partial, folder, error);
    if (!error) return success();
    if (hadEarlier) fs::rename(earlier, folder, ignored);
    return cannot("write", folder, error);
}

Status checkReplaceable(const fs::path& folder) {
    std::error_code ignored;
    if (!fs::exists(folder, ignored)) return success();
    if (!fs::is_directory(folder, ignored)) {
        return Error{ErrorCode::BadInput,
                     inQuotes(folder) + " is a file, not a folder; move it first or export elsewhere."};
    }
    const Result<std::optional<std::string>> unexpected = findUnexpectedFile(folder);
    if (!unexpected) return unexpected.error();
    if (!*unexpected) return success();
    return Error{ErrorCode::BadInput, "The folder " + inQuotes(folder) + " contains " + inQuotes(**unexpected) +
                                          ", which is not part of an export; move it first or export elsewhere."};
}

}  // namespace

bool isExportOf(const fs::path& folder, const ContentHash& source) {
    const std::optional<Manifest> manifest = readManifest(folder);
    if (!manifest || manifest->source != source.hex()) return false;
    return std::ranges::all_of(manifest->files, [&](const ManifestEntry& file) {
        const Result<std::string> bytes = readFile(folder / file.name);
        return bytes && entryOf(file.name, *bytes) == file;
    });
}

std::optional<std::string> verifyExportFolder(const fs::path& folder) {
    const std::optional<Manifest> manifest = readManifest(folder);
    if (!manifest) return "The folder " + inQuotes(folder) + " has no readable " + kManifestName + ".";
    for (const ManifestEntry& file : manifest->files) {
        const Result<std::string> bytes = readFile(folder / file.name);
        if (!bytes) return bytes.error().message;
        if (entryOf(file.name, *bytes) != file) return inQuotes(folder / file.name) + " was modified after the export.";
    }
    const Result<std::optional<std::string>> unexpected = findUnexpectedFile(folder);
    if (!unexpected) return unexpected.error().message;
    if (!*unexpected) return std::nullopt;
    return "The folder " + inQuotes(folder) + " contains " + inQuotes(**unexpected) +
           ", which is not part of the export.";
}

Status writeExportFolder(const fs::path& folder, const ContentHash& source, std::span<const ExportFile> files,
                         const TaskContext& task) {
    if (const Status free = checkReplaceable(folder); !free) return free;
    CreatedDirectories parents;
    if (folder.has_parent_path()) {
        if (const Status created = parents.create(folder.parent_path()); !created) return created;
    }
    const auto partial = HiddenFolder::create(folder, "partial");
    if (!partial) return partial.error();

    Manifest manifest{source.hex(), {}};
    for (const ExportFile& file : files) {
        if (task.isCancelled()) return TaskContext::cancelled();
        if (const Status written = writeNewFile((*partial)->path() / file.name, file.bytes); !written) return written;
        manifest.files.push_back(entryOf(file.name, file.bytes));
    }
    const Status listed = writeNewFile((*partial)->path() / kManifestName, manifestJson(manifest));
    if (!listed) return listed;
    const auto backup = HiddenFolder::create(folder, "replaced");
    if (!backup) return backup.error();
    return replaceFolder((*partial)->path(), folder, (*backup)->path());
}

}  // namespace rubble
