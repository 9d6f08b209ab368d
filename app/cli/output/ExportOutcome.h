#pragma once

#include "app/cli/output/VerbReport.h"
#include "core/io/pack/OutputFolder.h"

#include <string>
#include <vector>

namespace rubble {

/// What an export did, or would do.
struct ExportOutcome {
    bool isPlanned = false;  // nothing was written
    std::vector<AssetExport> packs;
    std::vector<PrunedFolder> pruned;
    std::vector<RenamedFolder> renamed;
    Status finished = success();  // an error if what is beside the packs could not be written
};

/// Returns why a pack is refused, with the option that overwrites it.
std::string refusalOf(const AssetExport& pack);

/// Prints a line for each pack and each folder, and warnings to standard error, and reports all of them. Returns an
/// error with a line for each of the first that failed.
Status printExport(const ExportOutcome& outcome, const std::string& project, VerbReport& report,
                   const CliContext& context);

}  // namespace rubble
