#include "core/io/output/ExportCheck.h"

#include "core/base/MessageText.h"
#include "core/io/output/ExportManifest.h"
#include "core/io/system/FolderReading.h"

#include <algorithm>
#include <array>
#include <system_error>
#include <vector>

namespace rubble {
namespace {

namespace fs = std::filesystem;

/// Files that engines write beside those that they import: Godot, Unity.
constexpr std::array kEngineSuffixes{".import", ".uid", ".meta"};

}  // namespace

bool isEngineFile(const fs::directory_entry& entry) {
    std::error_code ignored;
    const std::string suffix = entry.path().extension().string();
    const bool isFile = entry.symlink_status(ignored).type() == fs::file_type::regular;
    return std::ranges::find(kEngineSuffixes, suffix) != kEngineSuffixes.end() && isFile;
}

Result<std::optional<std::string>> findUnexpectedFile(const fs::path& folder) {
    const std::optional<Manifest> manifest = readManifest(folder);
    const Result<std::vector<fs::directory_entry>> entries = entriesOf(folder);
    if (!entries) return entries.error();
    std::vector<std::string> unexpected;
    for (const fs::directory_entry& entry : *entries) {
        const std::string name = entry.path().filename().string();
        const auto isListed = [&](const ManifestEntry& file) { return file.name == name; };
        const bool isExpected = manifest && (name == kManifestName || std::ranges::any_of(manifest->files, isListed));
        std::error_code ignored;
        if (isExpected ? entry.is_directory(ignored) : !isEngineFile(entry)) unexpected.push_back(name);
    }
    if (unexpected.empty()) return std::optional<std::string>();
    return std::optional(*std::ranges::min_element(unexpected));
}

Result<std::optional<fs::path>> findEditedFile(const fs::path& folder) {
    const std::optional<Manifest> manifest = readManifest(folder);
    if (!manifest) return std::optional<fs::path>();
    for (const ManifestEntry& file : manifest->files) {
        if (isLink(folder / file.name)) return std::optional(folder / file.name);
        const Result<ManifestEntry> current = manifestEntryOfFile(folder, file.name);
        if (!current && current.error().code != ErrorCode::NotFound) return current.error();
        if (current && *current != file) return std::optional(folder / file.name);
    }
    return std::optional<fs::path>();
}

bool isExportOf(const fs::path& folder, const ContentHash& source) {
    const std::optional<Manifest> manifest = readManifest(folder);
    if (!manifest || manifest->source != source.hex()) return false;
    return std::ranges::all_of(manifest->files, [&](const ManifestEntry& file) {
        const Result<ManifestEntry> current = manifestEntryOfFile(folder, file.name);
        return current && *current == file;
    });
}

std::optional<std::string> verifyExportFolder(const fs::path& folder) {
    const fs::path list = folder / kManifestName;
    if (isLink(list)) return quotedPath(list) + " is a link, which is not followed here; replace it by a file.";
    const std::optional<Manifest> manifest = readManifest(folder);
    if (!manifest) return "The folder " + quotedPath(folder) + " has no readable " + kManifestName + ".";
    for (const ManifestEntry& file : manifest->files) {
        const Result<ManifestEntry> current = manifestEntryOfFile(folder, file.name);
        if (!current) return current.error().message;
        if (*current != file) return quotedPath(folder / file.name) + " was modified after the export.";
    }
    const Result<std::optional<std::string>> unexpected = findUnexpectedFile(folder);
    if (!unexpected) return unexpected.error().message;
    if (!*unexpected) return std::nullopt;
    return "The folder " + quotedPath(folder) + " contains " + quotedPath(**unexpected) +
           ", which is not part of the export.";
}

}  // namespace rubble
