#pragma once

#include "app/cli/console/CliContext.h"
#include "core/base/Diagnostic.h"

#include <span>
#include <string>
#include <vector>

namespace rubble {

struct AssetWarnings {
    std::string asset;  // its name
    std::vector<Diagnostic> warnings;
};

/// Prints warnings to standard error, one per line. If there are more than three, it prints the first three, the number
/// of all, and a reference to "rubble-cli check PROJECT", which prints all.
void printWarnings(const CliContext& context, std::span<const AssetWarnings> assets, const std::string& project);

/// Returns the lines, without a line feed at the end; if there are more than three, the first three and the number of
/// the others.
std::string firstLinesOf(const std::vector<std::string>& lines);

}  // namespace rubble
