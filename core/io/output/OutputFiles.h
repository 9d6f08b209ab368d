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

/// Writes files of an export into the output folder itself, each atomically, and only if it differs, and removes those
/// that an earlier export wrote and this one has not, unless they were edited. Returns what the index is to list of
/// them. Before anything is changed, `announce` gets what it is to list until then, old files and new ones: so a
/// program that is killed leaves none that the next export takes for another's.
///
/// Errors: Edited if one of them is there that is not as `earlier` lists it, for `project`, and is to be kept; Io;
/// those of `announce`.
Result<std::vector<ManifestEntry>> writeOutputFiles(const std::filesystem::path& folder,
                                                    std::span<const ExportFile> files,
                                                    const std::optional<ExportIndex>& earlier,
                                                    const std::string& project, EditedFiles edited,
                                                    const AnnounceFiles& announce);

}  // namespace rubble
