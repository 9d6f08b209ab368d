#pragma once

#include "app/cli/console/CliContext.h"
#include "core/base/Diagnostic.h"

#include <string>
#include <vector>

namespace rubble {

/// Prints warnings about an asset to standard error, one per line. If there are more than three, it prints the first
/// three, their number, and a reference to "rubble-cli check PROJECT", which prints all.
void printWarnings(const CliContext& context, const std::string& asset, const std::vector<Diagnostic>& warnings,
                   const std::string& project);

}  // namespace rubble
