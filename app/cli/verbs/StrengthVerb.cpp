#include "app/cli/console/InputOutput.h"
#include "app/cli/options/AssetOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/bake/AssetBakes.h"
#include "core/asset/strength/Threshold.h"
#include "core/base/MessageText.h"
#include "core/io/play/StrengthReportJson.h"

#include <memory>

namespace rubble {
namespace {

constexpr const char* kStrengthFooter =
    R"(A strength requirement states that an asset survives or breaks when it falls from a height onto level ground in
its own orientation, or when a body of a given mass and speed hits the centre of its front squarely: off-centre hits do
less. An asset is free to move, or held in place where its instances are fixed. Prints the impulse of each requirement,
and for each asset the thresholds that satisfy all of them. If two requirements conflict, prints both and the gap
between them. Exits with 3 if requirements conflict or a threshold does not satisfy them; also where an asset with
requirements breaks along bonds, without a threshold.

Examples:
  rubble-cli strength house.rubble
  rubble-cli strength house.rubble --asset wall --json)";

struct StrengthOptions {
    std::string file;
    std::vector<std::string> assets;
    bool isJson = false;
    int threads = 1;
};

/// Why the requirements of an asset that breaks along bonds cannot be judged; nothing if it has none.
std::optional<std::string> faultOfBonded(const Asset& asset) {
    if (asset.requirements.empty()) return std::nullopt;
    return "it breaks along bonds, without a threshold, and strength requirements are for assets that break whole.";
}

Result<std::vector<StrengthReport>> reportsOn(const Project& project, std::span<const Id> assets,
                                              const TaskContext& task) {
    const Result<AssetBakes> bakes = bakesOf(project, assets, task);
    if (!bakes) return bakes.error();
    std::vector<StrengthReport> reports;
    for (const Id id : assets) {
        const Asset& asset = *findAsset(project, id);
        if (!hasThreshold(project, asset)) {
            reports.push_back({.asset = asset, .fault = faultOfBonded(asset)});
            continue;
        }
        const Result<PlayAsset> whole = wholePlayAsset(asset, bakes->at({id}));
        if (!whole) return whole.error();
        Result<ThresholdInterval> interval = thresholdInterval(project, *whole);
        if (!interval) return interval.error();
        reports.push_back({asset, thresholdOf(project, asset), std::move(*interval)});
    }
    return reports;
}

/// Returns whether the threshold of an asset satisfies its requirements, and which would.
std::string verdictOn(const StrengthReport& report) {
    const ThresholdInterval& interval = report.interval;
    if (!report.threshold) return report.fault ? "breaks along bonds\n" : "breaks along bonds, no requirements\n";
    const std::string threshold = "threshold " + impulseText(*report.threshold);
    if (report.asset.requirements.empty()) return threshold + ", no requirements\n";
    if (interval.isEmpty()) return threshold + "; the requirements conflict\n";
    if (interval.contains(*report.threshold)) {
        return threshold + ", satisfied: it must be " + intervalText(interval) + "\n";
    }
    return threshold + ", not satisfied: it must be " + intervalText(interval) + "; " +
           impulseText(*interval.suggested()) + " would satisfy all\n";
}

std::string textOf(const StrengthReport& report) {
    std::string text = shownName(report.asset.name) + ": " + verdictOn(report);
    for (std::size_t k = 0; k < report.asset.requirements.size(); ++k) {
        text += "  " + requirementText(report.asset.requirements[k]);
        text += report.fault ? ": not judged\n" : ": " + impulseText(report.interval.impulses[k]) + "\n";
    }
    return text;
}

/// Why the requirements of an asset are not satisfied; nothing if they are.
std::optional<std::string> unsatisfiedText(const StrengthReport& report) {
    if (report.fault) return report.fault;
    if (!report.threshold || report.asset.requirements.empty()) return std::nullopt;
    if (std::optional<std::string> conflict = conflictText(report.asset, report.interval)) return conflict;
    if (report.interval.contains(*report.threshold)) return std::nullopt;
    return "the threshold " + impulseText(*report.threshold) + " does not satisfy the requirements.";
}

Status strength(const StrengthOptions& options, VerbReport& report, const CliContext& context) {
    const Result<ProjectAssets> loaded = loadProjectAssets(options.file, options.assets, context);
    if (!loaded) return loaded.error();
    const TaskContext task{.cancel = context.cancel, .threads = options.threads};
    const Result<std::vector<StrengthReport>> reports = reportsOn(loaded->project, loaded->assets, task);
    if (!reports) return reports.error();
    std::string text;
    for (const StrengthReport& judged : *reports) {
        text += textOf(judged);
        if (const auto unsatisfied = unsatisfiedText(judged))
            conclude(report, shownName(judged.asset.name) + ": " + *unsatisfied);
    }
    return printText(options.isJson ? strengthReportJson(*reports) : text, context);
}

}  // namespace

Verb addStrength(CLI::App& program) {
    Command command(program, "strength", "Check the strength requirements of assets", kStrengthFooter);
    command.alias("intent");  // its old name
    const auto options = std::make_shared<StrengthOptions>();
    addProjectArgument(command, options->file);
    addAssetOption(command, options->assets);
    addJsonOption(command, options->isJson);
    addThreadsOption(command, options->threads);
    return {command,
            [options](VerbReport& report, const CliContext& context) { return strength(*options, report, context); }};
}

}  // namespace rubble
