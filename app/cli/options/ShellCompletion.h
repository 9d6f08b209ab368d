#pragma once

#include "app/cli/options/CommandTree.h"

#include <span>
#include <string>

namespace rubble {

/// Each function returns a script by which a shell completes verbs, options and values of rubble-cli.
std::string bashCompletion(std::span<const CommandTreeVerb> verbs);
std::string zshCompletion(std::span<const CommandTreeVerb> verbs);
std::string fishCompletion(std::span<const CommandTreeVerb> verbs);

}  // namespace rubble
