#include "app/cli/ChosenAssets.h"
#include "app/cli/CommonOptions.h"
#include "app/cli/Verb.h"
#include "core/asset/AssetBakes.h"
#include "core/asset/Threshold.h"
#include "core/io/IntentReportJson.h"
#include "core/io/ProjectFile.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(An intent is a sentence on an asset: it survives, or breaks, when it falls from a height onto level ground as it stands, or
when it is hit in the middle of its front by a body of some mass and speed. For each the impulse is told that the event
deals, and for all of an asset together which thresholds satisfy them. Where two intents conflict, they are named, with
how far they are apart, and the exit status is 1.

Examples:
  rubble-cli intent house.rubble
  rubble-cli intent house.rubble --asset wall --json)";

struct IntentOptions {
    std::string file;
    std::vector<std::string> assets;
    bool isJson = false;
    int threads = 1;
};

Result<std::vector<IntentReport>> reportsOn(const Project& project, std::span<const Id> assets,
                                            const TaskContext& task) {
    const Result<AssetBakes> bakes = bakesOf(project, assets, task);
    if (!bakes) return bakes.error();
    std::vector<IntentReport> reports;
    for (const Id id : assets) {
        const Asset& asset = *findAsset(project, id);
        const Result<PlayAsset> whole = playWhole(asset, bakes->at({id}));
        if (!whole) return whole.error();
        Result<ThresholdInterval> interval = thresholdInterval(project, *whole);
        if (!interval) return interval.error();
        reports.push_back({asset, thresholdOf(project, asset), std::move(*interval)});
    }
    return reports;
}

/// Whether the threshold of an asset satisfies its intents, and which would.
std::string verdictOn(const IntentReport& report) {
    const ThresholdInterval& interval = report.interval;
    const std::string threshold = "threshold " + impulseText(report.threshold);
    if (report.asset.intents.empty()) return threshold + ", no intents\n";
    if (interval.isEmpty()) return threshold + ", but the intents conflict\n";
    if (interval.contains(report.threshold)) {
        return threshold + ", fits: it must be " + intervalText(interval) + "\n";
    }
    return threshold + ", does not fit: it must be " + intervalText(interval) + "; " +
           impulseText(*interval.suggested()) + " would fit\n";
}

std::string textOf(const IntentReport& report) {
    std::string text = report.asset.name + ": " + verdictOn(report);
    for (std::size_t k = 0; k < report.asset.intents.size(); ++k) {
        text += "  " + intentText(report.asset.intents[k]) + ": " + impulseText(report.interval.impulses[k]) + "\n";
    }
    return text;
}

/// A sentence an asset whose intents conflict.
Status conflictsOf(std::span<const IntentReport> reports) {
    std::string conflicts;
    for (const IntentReport& report : reports) {
        if (const std::optional<std::string> conflict = conflictText(report.asset, report.interval)) {
            conflicts += (conflicts.empty() ? "" : "\n") + report.asset.name + ": " + *conflict;
        }
    }
    if (!conflicts.empty()) return Error{ErrorCode::BadInput, conflicts};
    return success();
}

Status intent(const IntentOptions& options, const CliContext& context) {
    const Result<Project> project = loadProject(options.file);
    if (!project) return project.error();
    const Result<std::vector<Id>> assets = chosenAssets(*project, options.assets);
    if (!assets) return assets.error();
    if (assets->empty()) return Error{ErrorCode::NotFound, "The project has no asset with intents."};
    const TaskContext task{.cancel = context.cancel, .threads = options.threads};
    const Result<std::vector<IntentReport>> reports = reportsOn(*project, *assets, task);
    if (!reports) return reports.error();
    std::string text;
    for (const IntentReport& report : *reports) text += textOf(report);
    const Status written = writeOutput("-", options.isJson ? intentReportJson(*reports) : text, context);
    return written ? conflictsOf(*reports) : written;
}

}  // namespace

Verb addIntent(CLI::App& program) {
    CLI::App* command = program.add_subcommand("intent", "Tell which thresholds satisfy what assets are to take");
    const auto options = std::make_shared<IntentOptions>();
    command->footer(kFooter);
    command->add_option("FILE", options->file, "The project")->required()->type_name("");
    addAssetOption(*command, options->assets);
    command->add_flag("--json", options->isJson, "For programs: JSON instead of text");
    addThreadsOption(*command, options->threads);
    return {command, [options](const CliContext& context) { return intent(*options, context); }};
}

}  // namespace rubble
