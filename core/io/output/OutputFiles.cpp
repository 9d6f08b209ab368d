#include "core/io/output/OutputFiles.h"

#include "core/base/MessageText.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/FileErrors.h"

#include <algorithm>

namespace rubble {
namespace {

/// Whether the index lists a file as it is now.
bool isListed(const std::optional<ExportIndex>& earlier, const IndexedProject& project, const ManifestEntry& file) {
    return isIndexOf(earlier, project) && std::ranges::find(earlier->files, file) != earlier->files.end();
}

/// Why a file that is there as `current` is not to be replaced; nothing if it may be.
std::optional<Error> whyKept(const std::filesystem::path& path, const ManifestEntry& current,
                             const std::optional<ExportIndex>& earlier, const IndexedProject& project,
                             EditedFiles edited) {
    if (isListed(earlier, project, current)) return std::nullopt;
    const bool isOfExport =
        earlier && std::ranges::find(earlier->files, current.name, &ManifestEntry::name) != earlier->files.end();
    constexpr const char* kAdvice = " and would be lost; move it first or export elsewhere.";
    if (!isOfExport) return Error{ErrorCode::BadInput, quotedPath(path) + " was not written by an export" + kAdvice};
    if (edited == EditedFiles::Replaced) return std::nullopt;
    const std::string reason = isIndexOf(earlier, project)
                                   ? std::string(" was modified after the export")
                                   : " is of the export of another project, " + quotedName(earlier->project.name) + ",";
    return Error{ErrorCode::Edited, quotedPath(path) + reason + kAdvice};
}

}  // namespace

Status checkOutputFiles(const std::filesystem::path& folder, std::span<const ExportFile> files,
                        const std::optional<ExportIndex>& earlier, const IndexedProject& project, EditedFiles edited) {
    for (const ExportFile& file : files) {
        const Result<ManifestEntry> current = manifestEntryOfFile(folder, file.name);
        if (!current && current.error().code != ErrorCode::NotFound) return current.error();
        if (!current || *current == manifestEntry(file.name, file.bytes)) continue;
        if (std::optional<Error> kept = whyKept(folder / file.name, *current, earlier, project, edited))
            return *std::move(kept);
    }
    return success();
}

Result<std::vector<ManifestEntry>> writeOutputFiles(const std::filesystem::path& folder,
                                                    std::span<const ExportFile> files,
                                                    const std::optional<ExportIndex>& earlier,
                                                    const IndexedProject& project, EditedFiles edited,
                                                    const AnnounceFiles& announce) {
    if (const Status free = checkOutputFiles(folder, files, earlier, project, edited); !free) return free.error();
    std::vector<ManifestEntry> entries, announced, gone;
    std::vector<const ExportFile*> changed;
    for (const ExportFile& file : files) {
        entries.push_back(manifestEntry(file.name, file.bytes));
        announced.push_back(entries.back());
        const Result<ManifestEntry> current = manifestEntryOfFile(folder, file.name);
        if (current && *current == entries.back()) continue;
        if (current) announced.push_back(*current);
        changed.push_back(&file);
    }
    for (const ManifestEntry& file : earlier ? earlier->files : std::vector<ManifestEntry>()) {
        const bool isWritten = std::ranges::find(files, file.name, &ExportFile::name) != files.end();
        const Result<ManifestEntry> current = manifestEntryOfFile(folder, file.name);
        if (!isWritten && current && *current == file && isListed(earlier, project, file)) gone.push_back(file);
    }
    announced.insert(announced.end(), gone.begin(), gone.end());
    if (changed.empty() && gone.empty()) return entries;
    if (const Status listed = announce(announced); !listed) return listed.error();
    for (const ExportFile* file : changed) {
        if (const Status written = writeFileAtomically(folder / file->name, file->bytes); !written)
            return written.error();
    }
    for (const ManifestEntry& file : gone) {
        std::error_code error;
        std::filesystem::remove(folder / file.name, error);
        if (error) return cannotWrite(folder / file.name, error.value());
    }
    return entries;
}

}  // namespace rubble
