#include "core/io/output/OutputFiles.h"

#include "core/base/MessageText.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/FileErrors.h"

#include <algorithm>

namespace rubble {
namespace {

/// Whether the index lists a file as it is now.
bool isListed(const std::optional<ExportIndex>& earlier, const std::string& project, const ManifestEntry& file) {
    return isIndexOf(earlier, project) && std::ranges::find(earlier->files, file) != earlier->files.end();
}

}  // namespace

Result<std::vector<ManifestEntry>> writeOutputFiles(const std::filesystem::path& folder,
                                                    std::span<const ExportFile> files,
                                                    const std::optional<ExportIndex>& earlier,
                                                    const std::string& project, EditedFiles edited,
                                                    const AnnounceFiles& announce) {
    std::vector<ManifestEntry> entries, announced, gone;
    std::vector<const ExportFile*> changed;
    for (const ExportFile& file : files) {
        entries.push_back(manifestEntry(file.name, file.bytes));
        announced.push_back(entries.back());
        const Result<ManifestEntry> current = manifestEntryOfFile(folder, file.name);
        if (current && *current == entries.back()) continue;
        if (!current && current.error().code != ErrorCode::NotFound) return current.error();
        if (current && edited == EditedFiles::Kept && !isListed(earlier, project, *current)) {
            return Error{ErrorCode::Edited, quotedPath(folder / file.name) +
                                                " was not written by an export of this project, or was modified after "
                                                "it, and would be lost; move it first or export elsewhere."};
        }
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
