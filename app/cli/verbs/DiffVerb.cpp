#include "app/cli/console/InputOutput.h"
#include "app/cli/console/ProgressLine.h"
#include "app/cli/options/AssetOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/verbs/Verb.h"
#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/io/project/ProjectDifferenceJson.h"

#include <algorithm>
#include <memory>

namespace rubble {
namespace {

constexpr const char* kDiffFooter =
    R"(Compares two saved states of a project. Of each asset: the changed properties (outline, depth, material,
threshold, layers, ...), and the fragments that were removed, added, moved or reshaped. Fragments are matched by
their ids, assets by their names, or by their ids if they were renamed. Then, without --asset, everything else
that a project holds: materials, instances, ground, gravity, damage, debris, shots and tests, matched by id or
name. Exits with 0 if nothing differs, with 3 if something does, and with 1 if a file cannot be read.

Examples:
  rubble-cli diff before.rubble house.rubble
  rubble-cli diff before.rubble house.rubble --asset wall --all
  rubble-cli diff before.rubble house.rubble --json)";

constexpr std::size_t kMaxListed = 10;  // fragments of each change, without --all

struct DiffOptions {
    std::string before;
    std::string after;
    std::vector<std::string> assets;
    bool isAll = false;
    bool isJson = false;
    int threads = 1;
};

/// Returns the pairs with these names; all if `names` is empty.
Result<std::vector<AssetPair>> selectedPairs(std::vector<AssetPair> pairs, const std::vector<std::string>& names) {
    const auto hasName = [](const AssetPair& pair, const std::string& name) {
        return (pair.before && pair.before->name == name) || (pair.after && pair.after->name == name);
    };
    for (const std::string& name : names) {
        if (std::ranges::any_of(pairs, [&](const AssetPair& pair) { return hasName(pair, name); })) continue;
        return Error{ErrorCode::NotFound, "Neither project has an asset " + quotedName(name) + "."};
    }
    std::erase_if(pairs, [&](const AssetPair& pair) {
        return !names.empty() &&
               std::ranges::none_of(names, [&](const std::string& name) { return hasName(pair, name); });
    });
    return pairs;
}

/// Returns a line for each fragment, grouped by change; at most kMaxListed of each change unless `isAll`.
std::string changesText(const BakeDifference& difference, bool isAll) {
    std::string text;
    for (auto begin = difference.fragments.begin(); begin != difference.fragments.end();) {
        const auto end =
            std::ranges::find_if(begin, difference.fragments.end(),
                                 [&](const FragmentDifference& fragment) { return fragment.change != begin->change; });
        const auto count = static_cast<std::size_t>(end - begin);
        const std::size_t listed = isAll ? count : std::min(count, kMaxListed);
        for (std::size_t k = 0; k < listed; ++k) text += "  " + sentenceOf(*begin++) + '\n';
        if (listed < count) text += "  … and " + std::to_string(count - listed) + " more; --all lists them\n";
        begin = end;
    }
    return text;
}

std::string textOf(const AssetDifference& difference, bool isAll) {
    const AssetPair& pair = difference.pair;
    const std::string name = shownName(pair.name());
    if (difference.isEmpty()) return name + ": same\n";
    if (!pair.before)
        return name + ": added, " + countText(difference.fragments.sum().after, "fragment", "fragments") + "\n";
    if (!pair.after)
        return name + ": removed, had " + countText(difference.fragments.sum().before, "fragment", "fragments") + "\n";
    std::string text = name + ": changed\n";
    for (const RecipeChange& change : difference.recipe) text += "  " + sentenceOf(change) + '\n';
    const std::vector<LevelDifference>& levels = difference.fragments.levels;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        text += (levels.size() > 1 ? "  level " + std::to_string(k) + ": " : "  ") + sentenceOf(levels[k]) + '\n';
    }
    return text + changesText(difference.fragments, isAll);
}

std::string textOf(const ProjectDifference& difference, bool isAll) {
    std::string text;
    for (const AssetDifference& asset : difference.assets) text += textOf(asset, isAll);
    for (const RecipeChange& change : difference.settings) text += sentenceOf(change) + '\n';
    return text;
}

/// Reports what differs: "1 of 4 assets and 2 other settings differ."
void reportDifference(const ProjectDifference& difference, VerbReport& report) {
    if (difference.isEmpty()) return;
    const std::size_t count = difference.assets.size(), settings = difference.settings.size();
    const auto same = static_cast<std::size_t>(std::ranges::count_if(difference.assets, &AssetDifference::isEmpty));
    std::string what;
    if (same < count) what = std::to_string(count - same) + " of " + countText(count, "asset", "assets");
    if (settings > 0) {
        const std::string other = same < count ? "other " : "";
        what += (what.empty() ? "" : " and ") + countText(settings, other + "setting", other + "settings");
    }
    const bool isOne = same < count ? count == 1 && settings == 0 : settings == 1;
    conclude(report, what + (isOne ? " differs." : " differ."));
}

Status diff(const DiffOptions& options, VerbReport& report, const CliContext& context) {
    const Result<Project> before = openProject(options.before, context);
    if (!before) return before.error();
    const Result<Project> after = openProject(options.after, context);
    if (!after) return after.error();
    const Result<std::vector<AssetPair>> pairs = selectedPairs(assetPairs(*before, *after), options.assets);
    if (!pairs) return pairs.error();
    ProgressLine line(context, "Comparing");
    const TaskContext task{context.cancel, [&](double fraction) { line.show(fraction); }, options.threads};
    Result<ProjectDifference> difference = projectDifference(*before, *after, *pairs, task);
    line.clear();
    if (!difference) return difference.error();
    if (options.assets.empty()) difference->settings = settingChanges(*before, *after);
    const std::string text = options.isJson ? projectDifferenceJson(*difference) : textOf(*difference, options.isAll);
    reportDifference(*difference, report);
    return printText(text, context);
}

}  // namespace

Verb addDiff(CLI::App& program) {
    Command command(program, "diff", "Compare two saved states of a project", kDiffFooter);
    const auto options = std::make_shared<DiffOptions>();
    command.argument("BEFORE", options->before, "The project before the change").required();
    command.argument("AFTER", options->after, "The project after the change").required();
    addAssetOption(command, options->assets);
    command.flag("--all", options->isAll, "List every fragment, not only the first ten of each change");
    addJsonOption(command, options->isJson);
    addThreadsOption(command, options->threads);
    return {command,
            [options](VerbReport& report, const CliContext& context) { return diff(*options, report, context); }};
}

}  // namespace rubble
