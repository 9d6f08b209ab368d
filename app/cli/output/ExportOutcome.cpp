#include "app/cli/output/ExportOutcome.h"

#include "app/cli/output/FragmentsText.h"
#include "app/cli/output/Warnings.h"
#include "core/base/MessageText.h"
#include "core/io/json/JsonWriter.h"

namespace rubble {
namespace {

std::string summaryOf(const AssetExport& pack, bool isPlanned) {
    const std::string name = shownName(pack.name) + ": ", folder = pack.folder.string() + '\n';
    if (pack.isUnchanged) return name + "unchanged in " + folder;
    if (isPlanned) return name + (pack.isReplacing ? "would be replaced in " : "would be written to ") + folder;
    return name + fragmentsText(pack.fragmentCount, pack.volume) + ", exported to " + folder;
}

const char* actionOf(const AssetExport& pack) {
    if (!pack.status) return "refused";
    if (pack.isUnchanged) return "unchanged";
    return pack.isReplacing ? "replaced" : "written";
}

void writePack(JsonWriter& json, const AssetExport& pack) {
    json.openObject({}, JsonLayout::Inline);
    json.text("asset", printableText(pack.name));
    json.text("folder", printableText(pack.folder.string()));
    json.text("action", actionOf(pack));
    if (pack.fragmentCount > 0) {
        json.wholeNumber("fragments", std::uint64_t{pack.fragmentCount});
        json.number("volume", pack.volume);
    }
    json.close();
}

void writePruned(JsonWriter& json, const PrunedFolder& pruned) {
    json.openObject({}, JsonLayout::Inline);
    json.text("folder", printableText(pruned.folder.string()));
    json.text("action", pruned.status ? "removed" : "refused");
    json.close();
}

/// Reports packs and folders, and their warnings and errors as findings.
void reportExport(const ExportOutcome& outcome, const std::string& project, VerbReport& report) {
    const auto addError = [&report](const Error& error, FindingPlace place) {
        report.findings.push_back(findingOf(error, std::move(place)));
        report.hasErrorInFindings = true;
    };
    for (const AssetExport& pack : outcome.packs) {
        for (const Diagnostic& diagnostic : pack.diagnostics)
            report.findings.push_back(findingOf(diagnostic, project, pack.name));
        if (!pack.status)
            addError({pack.status.error().code, refusalOf(pack)}, {.file = pack.folder.string(), .asset = pack.name});
    }
    for (const PrunedFolder& pruned : outcome.pruned) {
        if (!pruned.status) addError(pruned.status.error(), {.file = pruned.folder.string()});
    }
    report.writeResults = [outcome](JsonWriter& json) {
        json.boolean("dryRun", outcome.isPlanned);
        json.list("packs", outcome.packs, writePack);
        json.list("pruned", outcome.pruned, writePruned);
    };
}

}  // namespace

std::string refusalOf(const AssetExport& pack) {
    const Error& error = pack.status.error();
    return error.message + (error.code == ErrorCode::Edited ? " Use --overwrite to replace it." : "");
}

Status printExport(const ExportOutcome& outcome, const std::string& project, VerbReport& report,
                   const CliContext& context) {
    reportExport(outcome, project, report);
    std::string summary;
    std::vector<AssetWarnings> warnings;
    std::vector<std::string> errors;
    for (const AssetExport& pack : outcome.packs) {
        warnings.push_back({pack.name, pack.diagnostics});
        if (pack.status) {
            summary += summaryOf(pack, outcome.isPlanned);
        } else if (errors.empty() || errors.back() != refusalOf(pack)) {  // all fail alike if the folder does
            errors.push_back(refusalOf(pack));
        }
    }
    for (const auto& [from, to] : outcome.renamed)
        summary += "Folder " + from + " renamed to " + to + ", as its asset.\n";
    for (const PrunedFolder& pruned : outcome.pruned) {
        if (pruned.status) {
            summary += pruned.folder.string() + (outcome.isPlanned ? " would be removed\n" : " removed\n");
        } else {
            errors.push_back(pruned.status.error().message);
        }
    }
    printWarnings(context, warnings, project);
    if (const Status written = printSummary(summary, report, context); !written) return written;
    if (!errors.empty()) return Error{ErrorCode::BadInput, firstLinesOf(errors)};
    return success();
}

}  // namespace rubble
