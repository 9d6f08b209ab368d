#pragma once

#include "core/asset/import/AssetImport.h"

#include <string>

namespace rubble {

/// Returns a summary of an import: a paragraph for each asset.
std::string importSummary(const ImportOutcome& outcome, const std::string& projectPath);

}  // namespace rubble
