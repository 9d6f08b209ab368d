#pragma once

#include "app/cli/console/CliContext.h"
#include "core/base/Diagnostic.h"

#include <string>
#include <vector>

namespace rubble {

/// Prints warnings about an asset to standard error, a line each. Of more than three it prints the first three, their
/// number, and that "rubble-cli check PROJECT" prints all.
void printWarnings(const CliContext& context, const std::string& asset, const std::vector<Diagnostic>& warnings,
                   const std::string& project);

}  // namespace rubble
