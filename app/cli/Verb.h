#pragma once

#include "app/cli/Cli.h"
#include "core/base/Result.h"

#include <functional>

namespace CLI {
class App;
}

namespace rubble {

/// What a verb does once its options are read. A fault is told to the user by whoever runs it.
using VerbAction = std::function<Status(const CliContext& context)>;

/// A verb of the command line: how it is told on it, and what it does.
struct Verb {
    CLI::App* command = nullptr;  // owned by the program's CLI::App
    VerbAction action;
};

/// Each adds its verb with options and help to the program.
Verb addNew(CLI::App& program);
Verb addImport(CLI::App& program);
Verb addSeeds(CLI::App& program);
Verb addFracture(CLI::App& program);
Verb addExport(CLI::App& program);
Verb addCheck(CLI::App& program);
Verb addDraw(CLI::App& program);
Verb addRender(CLI::App& program);
Verb addFilm(CLI::App& program);
Verb addSimulate(CLI::App& program);
Verb addReplay(CLI::App& program);
Verb addTest(CLI::App& program);
Verb addIntent(CLI::App& program);
Verb addAudit(CLI::App& program);
Verb addMaterials(CLI::App& program);
Verb addDiff(CLI::App& program);
Verb addSheet(CLI::App& program);

/// The whole of a file, or of `context.in` where `path` is "-".
///
/// Errors: those of readFile(); Io where the input cannot be read.
Result<std::string> readInput(const std::string& path, const CliContext& context);

/// Writes text to a file atomically, or to `context.out` where `path` is "-".
///
/// Errors: those of writeFileAtomically(); Io where the output takes no more.
Status writeOutput(const std::string& path, std::string_view text, const CliContext& context);

}  // namespace rubble
