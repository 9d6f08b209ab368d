#pragma once

#include "core/base/Result.h"
#include "core/io/output/ExportFolder.h"
#include "core/io/output/ExportIndex.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace rubble {

/// Sets the files that the index lists.
using AnnounceFiles = std::function<Status(std::span<const ManifestEntry>)>;

/// Whether writeOutputFiles() could write files, or they are there already. Changes nothing.
///
/// Errors: Edited if one is there that `earlier` lists, but not as it is now, or for another project, and that is to be
/// kept; BadInput if `earlier` does not list it: no export wrote it, so none replaces it; Io.
Status checkOutputFiles(const std::filesystem::path& folder, std::span<const ExportFile> files,
                        const std::optional<ExportIndex>& earlier, const IndexedProject& project, EditedFiles edited);

/// Writes files of an export into the output folder itself, each atomically, and only if it differs, and removes those
/// that an earlier export wrote and this one has not, unless they were edited. Returns what the index is to list of
/// them. Before anything is changed, `announce` gets what it is to list until then, old files and new ones: so a
/// program that is killed leaves none that the next export takes for another's.
///
/// Errors: those of checkOutputFiles(); Io; those of `announce`.
Result<std::vector<ManifestEntry>> writeOutputFiles(const std::filesystem::path& folder,
                                                    std::span<const ExportFile> files,
                                                    const std::optional<ExportIndex>& earlier,
                                                    const IndexedProject& project, EditedFiles edited,
                                                    const AnnounceFiles& announce);

}  // namespace rubble
