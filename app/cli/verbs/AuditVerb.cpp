#include "app/cli/console/InputOutput.h"
#include "app/cli/console/ProgressLine.h"
#include "app/cli/options/AssetOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/bake/AssetBakes.h"
#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/io/play/SwapAuditJson.h"

#include <memory>

namespace rubble {
namespace {

constexpr const char* kAuditFooter =
    R"(Measures whether replacing an asset by its fragments changes anything by itself. Each asset is broken three
times without any force: floating at rest without gravity, level by level; prisms also lying flat on the ground; and
flying while it rotates. Prints the contacts right after the swap, the deepest overlap, the fastest fragment after 30
steps of 1/60 s (lying flat: on average of them), the changes of mass, momentum, angular momentum and energy, and
how far the hulls in exports are apart: other engines push those apart that are closer than 20 µm.
An asset is clean if no fragment moves faster than 1 mm/s at rest and 10 mm/s lying flat, and nothing is lost or
gained in flight, but for the mass that a gap or mortar takes from its fragments. Otherwise the program says what
to change and exits with 3.

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
    if ((*ready)->fractureOf(kNone) == nullptr) return named;
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

std::string speedText(const FragmentSpeed& fastest) {
    return quantityText(QuantityKind::Speed, fastest.speed) + " (" + fastest.fragment + ")";
}

std::string textOf(const NamedAudit& named) {
    if (!named.audit) return shownName(named.name) + ": does not break\n";
    const SwapAudit& audit = *named.audit;
    std::string text = shownName(named.name) + ": " + countText(audit.fragments, "fragment", "fragments") + ", " +
                       (audit.isClean() ? "clean" : "not clean") + "\n";
    text += "  contacts after the swap: " + std::to_string(audit.contacts) + " with " +
            countText(audit.contactPoints, "point", "points") + "; deepest overlap " +
            quantityText(QuantityKind::Length, audit.deepestOverlap) + "\n";
    text += "  fastest after 30 steps: " + speedText(audit.resting) + " at rest";
    text += audit.lying.fragment.empty() ? "\n" : ", " + speedText(audit.lying) + " lying flat\n";
    if (!audit.exported.fragment.empty()) {
        text += "  exported hulls are at least " + quantityText(QuantityKind::Length, audit.exported.gap) + " apart (" +
                audit.exported.fragment + ")\n";
    }
    text += "  relative change in flight: mass " + roundedText(audit.massDrift, 2) + ", momentum " +
            roundedText(audit.momentumDrift, 2) + ", angular momentum " + roundedText(audit.angularDrift, 2) +
            ", energy " + roundedText(audit.energyGain, 2) + "\n";
    for (const Diagnostic& diagnostic : audit.diagnostics) {
        if (diagnostic.severity == Severity::Note) text += "  " + diagnostic.message + "\n";
    }
    return text;
}

/// Reports a line for each failed measurement.
void reportFailures(std::span<const NamedAudit> audits, VerbReport& report) {
    for (const NamedAudit& named : audits) {
        if (!named.audit) continue;
        for (const Diagnostic& diagnostic : named.audit->diagnostics) {
            if (diagnostic.severity == Severity::Note) continue;
            conclude(report, shownName(named.name) + ": " + diagnostic.message);
        }
    }
}

Status audit(const AuditOptions& options, VerbReport& report, const CliContext& context) {
    const Result<ProjectAssets> loaded = loadProjectAssets(options.file, options.assets, context);
    if (!loaded) return loaded.error();
    const Result<std::vector<NamedAudit>> audits = auditsOf(loaded->project, loaded->assets, options, context);
    if (!audits) return audits.error();
    std::string text;
    for (const NamedAudit& named : *audits) text += textOf(named);
    reportFailures(*audits, report);
    return printText(options.isJson ? swapAuditJson(*audits) : text, context);
}

}  // namespace

Verb addAudit(CLI::App& program) {
    Command command(program, "audit", "Measure whether assets change when they are replaced by their fragments",
                    kAuditFooter);
    const auto options = std::make_shared<AuditOptions>();
    addProjectArgument(command, options->file);
    addAssetOption(command, options->assets);
    addJsonOption(command, options->isJson);
    addThreadsOption(command, options->threads);
    return {command,
            [options](VerbReport& report, const CliContext& context) { return audit(*options, report, context); }};
}

}  // namespace rubble
