#include "app/cli/console/InputOutput.h"

#include "core/base/MessageText.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/StreamReading.h"

#include <ostream>

namespace rubble {

Result<std::string> readInput(const std::string& path, const CliContext& context) {
    if (path == "-") return readStream(context.in, "standard input", context.cancel);
    return readFileOrStream(path, context.cancel);
}

Status writeOutput(const std::string& path, std::string_view text, const CliContext& context) {
    if (path != "-") return writeFileOrStream(path, text);
    context.out << text << std::flush;
    if (!context.out) return Error{ErrorCode::Io, "Standard output cannot be written. Is the disk full?"};
    return success();
}

Status printText(std::string_view text, const CliContext& context) {
    return writeOutput("-", printableText(text), context);
}

}  // namespace rubble
