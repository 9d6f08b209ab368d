#pragma once

#include "core/asset/AssetImport.h"

#include <string>

namespace rubble {

/// What an import found and did, for people to read: a paragraph an asset.
std::string importSummary(const ImportOutcome& outcome, const std::string& projectPath);

}  // namespace rubble
