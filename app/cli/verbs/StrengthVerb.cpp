#include "app/cli/console/InputOutput.h"
#include "app/cli/options/AssetOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/bake/AssetBakes.h"
#include "core/asset/strength/BondStrength.h"
#include "core/asset/strength/Threshold.h"
#include "core/base/MessageText.h"
#include "core/io/play/StrengthReportJson.h"

#include <memory>

namespace rubble {
namespace {

constexpr const char* kStrengthFooter =
    R"(A strength requirement states that an asset survives, breaks or gets a hole of at most a width when it falls from
a height onto level ground in its own orientation, or when a body of a given mass and speed hits the centre of its front
squarely: off-centre hits do less. An asset is free to move, or held in place where its instances are. Prints the
impulse of each requirement, and for each asset the thresholds that satisfy all of them. If two requirements conflict,
prints both and the gap between them. Of an asset that breaks along bonds, prints the impulse per area of bonds instead,
from which on none breaks, or no hole is wider, at the first contact. Exits with 3 if requirements conflict or are not
satisfied.

Examples:
  rubble-cli strength house.rubble
  rubble-cli strength house.rubble --asset wall --json)";

struct StrengthOptions {
    std::string file;
    std::vector<std::string> assets;
    bool isJson = false;
    int threads = 1;
};

Result<StrengthReport> reportOn(const Project& project, const Asset& asset, const std::shared_ptr<const Bake>& bake,
                                const TaskContext& task) {
    if (hasThreshold(project, asset)) {
        const Result<PlayAsset> whole = wholePlayAsset(asset, bake);
        if (!whole) return whole.error();
        Result<ThresholdInterval> interval = thresholdInterval(project, *whole);
        if (!interval) return interval.error();
        return StrengthReport{asset, thresholdOf(project, asset), std::move(*interval)};
    }
    Result<std::shared_ptr<const PlayAsset>> ready = playAsset(asset, bake, task, FindContacts::OnBreak);
    if (!ready) return ready.error();
    Result<ThresholdInterval> interval = bondInterval(project, std::move(*ready));
    if (!interval) return interval.error();
    return StrengthReport{asset, bondImpulseOf(asset, *findMaterial(project, asset.material)), std::move(*interval)};
}

Result<std::vector<StrengthReport>> reportsOn(const Project& project, std::span<const Id> assets,
                                              const TaskContext& task) {
    const Result<AssetBakes> bakes = bakesOf(project, assets, task);
    if (!bakes) return bakes.error();
    std::vector<StrengthReport> reports;
    for (const Id id : assets) {
        Result<StrengthReport> report = reportOn(project, *findAsset(project, id), bakes->at({id}), task);
        if (!report) return report.error();
        reports.push_back(std::move(*report));
    }
    return reports;
}

std::string strengthText(const StrengthReport& report) {
    const bool isPerArea = report.interval.isPerArea;
    return (isPerArea ? "impulse per area " : "threshold ") + impulseText(report.strength, isPerArea);
}

/// Returns whether the strength of an asset satisfies its requirements, and which would.
std::string verdictOn(const StrengthReport& report) {
    const ThresholdInterval& interval = report.interval;
    const std::string strength = strengthText(report);
    if (report.asset.requirements.empty()) return strength + ", no requirements\n";
    if (interval.isEmpty()) return strength + "; the requirements conflict\n";
    if (interval.contains(report.strength))
        return strength + ", satisfied: it must be " + intervalText(interval) + "\n";
    const std::optional<double> suggested = interval.suggested();
    return strength + ", not satisfied: it must be " + intervalText(interval) + "; " +
           (suggested ? impulseText(*suggested, interval.isPerArea) + " would satisfy all\n"
                      : "that is out of range\n");
}

std::string textOf(const StrengthReport& report) {
    std::string text = shownName(report.asset.name) + ": " + verdictOn(report);
    for (std::size_t k = 0; k < report.asset.requirements.size(); ++k) {
        text += "  " + requirementText(report.asset.requirements[k]) + ": " +
                impulseText(report.interval.impulses[k], report.interval.isPerArea) + "\n";
    }
    return text;
}

/// Why the requirements of an asset are not satisfied; nothing if they are.
std::optional<std::string> unsatisfiedText(const StrengthReport& report) {
    if (report.asset.requirements.empty()) return std::nullopt;
    if (std::optional<std::string> conflict = conflictText(report.asset, report.interval)) return conflict;
    if (report.interval.contains(report.strength)) return std::nullopt;
    return "the " + strengthText(report) + " does not satisfy the requirements.";
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
    const auto options = std::make_shared<StrengthOptions>();
    addProjectArgument(command, options->file);
    addAssetOption(command, options->assets);
    addJsonOption(command, options->isJson);
    addThreadsOption(command, options->threads);
    return {command,
            [options](VerbReport& report, const CliContext& context) { return strength(*options, report, context); }};
}

}  // namespace rubble
