#pragma once

#include "app/cli/console/CliContext.h"
#include "core/base/MessageText.h"
#include "core/base/Result.h"

#include <string>
#include <string_view>

namespace rubble {

/// Returns the contents of a file, pipe or device, or of `context.in` where `path` is "-".
///
/// Errors: those of readFileOrStream().
Result<std::string> readInput(const std::string& path, const CliContext& context);

/// Writes text to a file atomically, or to `context.out` where `path` is "-".
///
/// Errors: those of writeFileOrStream(); Io if the output cannot be written.
Status writeOutput(const std::string& path, std::string_view text, const CliContext& context);

/// Writes printableText() of a result, a line or JSON, to `context.out`.
///
/// Errors: Io if the output cannot be written.
Status printText(std::string_view text, const CliContext& context);

}  // namespace rubble
