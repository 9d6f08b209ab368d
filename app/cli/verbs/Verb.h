#pragma once

#include "app/cli/console/CliContext.h"
#include "app/cli/options/Command.h"
#include "app/cli/output/VerbReport.h"
#include "core/base/Result.h"

#include <functional>

namespace rubble {

/// Runs a verb after its options are parsed. The caller prints its error, or else what it found.
using VerbAction = std::function<Status(VerbReport& report, const CliContext& context)>;

/// A verb of rubble-cli.
struct Verb {
    Command command;
    VerbAction action;
};

/// Each function adds a verb with its options and help to the program.
Verb addNew(CLI::App& program);
Verb addImport(CLI::App& program);
Verb addSeeds(CLI::App& program);
Verb addFracture(CLI::App& program);
Verb addExport(CLI::App& program);
Verb addCheck(CLI::App& program);
Verb addDraw(CLI::App& program);
Verb addRender(CLI::App& program);
Verb addVideo(CLI::App& program);
Verb addSimulate(CLI::App& program);
Verb addReplay(CLI::App& program);
Verb addTest(CLI::App& program);
Verb addStrength(CLI::App& program);
Verb addAudit(CLI::App& program);
Verb addMaterials(CLI::App& program);
Verb addDiff(CLI::App& program);
Verb addSheet(CLI::App& program);
Verb addQuery(CLI::App& program);
Verb addDamage(CLI::App& program);
Verb addClusters(CLI::App& program);
Verb addCompletion(CLI::App& program);

}  // namespace rubble
