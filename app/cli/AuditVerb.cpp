#include "app/cli/ChosenAssets.h"
#include "app/cli/CommonOptions.h"
#include "app/cli/ProgressLine.h"
#include "app/cli/Verb.h"
#include "core/asset/AssetBakes.h"
#include "core/base/MessageText.h"
#include "core/io/ProjectFile.h"
#include "core/io/SwapAuditJson.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(A swap of an asset for its pieces must change nothing by itself. Each asset is swapped three times by no force: floating at
rest without gravity, level by level; lying flat on the ground; and flying as it turns. Told are the contacts right after
the swap, the deepest overlap, the fastest piece after 30 steps of 1/60 s, and what the swap did to mass, momentum,
angular momentum and energy. Clean is: at most 1 mm/s at rest and 10 mm/s lying; nothing lost or gained in flight. What is
not clean is told with what to change, and the exit status is 1.

Examples:
  rubble-cli audit house.rubble
  rubble-cli audit house.rubble --asset roof --json)";

struct AuditOptions {
    std::string file;
    std::vector<std::string> assets;
    bool isJson = false;
    int threads = 1;
};

Result<NamedAudit> auditOf(const Project& project, const Asset& asset, std::shared_ptr<const Bake> bake,
                           const TaskContext& task) {
    const Result<std::shared_ptr<const PlayAsset>> ready = playAsset(asset, std::move(bake), task);
    if (!ready) return ready.error();
    NamedAudit named{.name = asset.name};
    if ((*ready)->breakingOf(kNone) == nullptr) return named;
    Result<SwapAudit> audit = swapAudit(project, *ready);
    if (!audit) return audit.error();
    named.audit = std::move(*audit);
    return named;
}

Result<std::vector<NamedAudit>> auditsOf(const Project& project, std::span<const Id> assets,
                                         const AuditOptions& options, const CliContext& context) {
    const TaskContext task{.cancel = context.cancel, .threads = options.threads};
    const Result<AssetBakes> bakes = bakesOf(project, assets, task);
    if (!bakes) return bakes.error();
    ProgressLine line(context, "Auditing");
    std::vector<NamedAudit> audits;
    for (const Id id : assets) {
        if (task.isCancelled()) return TaskContext::cancelled();
        line.show(static_cast<double>(audits.size()) / static_cast<double>(assets.size()));
        Result<NamedAudit> audit = auditOf(project, *findAsset(project, id), bakes->at({id}), task);
        if (!audit) return audit.error();
        audits.push_back(std::move(*audit));
    }
    line.clear();
    return audits;
}

std::string speedText(const PieceSpeed& fastest) {
    return roundedText(1e3 * fastest.speed, 3) + " mm/s (" + fastest.piece + ")";
}

std::string textOf(const NamedAudit& named) {
    if (!named.audit) return named.name + ": breaks into nothing\n";
    const SwapAudit& audit = *named.audit;
    std::string text = named.name + ": " + std::to_string(audit.pieces) + " pieces, " +
                       (audit.isClean() ? "clean" : "not clean") + "\n";
    text += "  contacts at the swap: " + std::to_string(audit.contacts) + " with " +
            std::to_string(audit.contactPoints) + " points; deepest overlap " +
            roundedText(1e3 * audit.deepestOverlap, 2) + " mm\n";
    text += "  fastest after 30 steps: " + speedText(audit.resting) + " at rest, " + speedText(audit.lying) +
            " lying flat\n";
    text += "  changed in flight: mass " + roundedText(audit.massDrift, 2) + ", momentum " +
            roundedText(audit.momentumDrift, 2) + ", angular momentum " + roundedText(audit.angularDrift, 2) +
            ", energy " + roundedText(audit.energyGain, 2) + "\n";
    for (const std::string& notice : audit.notices) text += "  " + notice + "\n";
    return text;
}

/// A sentence a fault, with the asset's name.
Status faultsOf(std::span<const NamedAudit> audits) {
    std::string faults;
    for (const NamedAudit& named : audits) {
        if (!named.audit) continue;
        for (const std::string& fault : named.audit->faults) {
            faults += (faults.empty() ? "" : "\n") + named.name + ": " + fault;
        }
    }
    if (!faults.empty()) return Error{ErrorCode::BadInput, faults};
    return success();
}

Status audit(const AuditOptions& options, const CliContext& context) {
    const Result<Project> project = loadProject(options.file);
    if (!project) return project.error();
    const Result<std::vector<Id>> assets = chosenAssets(*project, options.assets);
    if (!assets) return assets.error();
    if (assets->empty()) return Error{ErrorCode::NotFound, "The project has no asset to audit."};
    const Result<std::vector<NamedAudit>> audits = auditsOf(*project, *assets, options, context);
    if (!audits) return audits.error();
    std::string text;
    for (const NamedAudit& named : *audits) text += textOf(named);
    const Status written = writeOutput("-", options.isJson ? swapAuditJson(*audits) : text, context);
    return written ? faultsOf(*audits) : written;
}

}  // namespace

Verb addAudit(CLI::App& program) {
    CLI::App* command = program.add_subcommand("audit", "Measure whether swaps of assets for their pieces are clean");
    const auto options = std::make_shared<AuditOptions>();
    command->footer(kFooter);
    command->add_option("FILE", options->file, "The project")->required()->type_name("");
    addAssetOption(*command, options->assets);
    command->add_flag("--json", options->isJson, "For programs: JSON instead of text");
    addThreadsOption(*command, options->threads);
    return {command, [options](const CliContext& context) { return audit(*options, context); }};
}

}  // namespace rubble
