#include "app/cli/console/InputOutput.h"

#include "core/io/system/AtomicFile.h"

#include <istream>
#include <iterator>
#include <ostream>

namespace rubble {

Result<std::string> readInput(const std::string& path, const CliContext& context) {
    if (path != "-") return readFile(path);
    std::string text{std::istreambuf_iterator<char>(context.in), {}};
    if (context.in.bad()) return Error{ErrorCode::Io, "Standard input cannot be read."};
    return text;
}

Status writeOutput(const std::string& path, std::string_view text, const CliContext& context) {
    if (path != "-") return writeFileAtomically(path, text);
    context.out << text << std::flush;
    if (!context.out) return Error{ErrorCode::Io, "Standard output cannot be written. Is the disk full?"};
    return success();
}

}  // namespace rubble
