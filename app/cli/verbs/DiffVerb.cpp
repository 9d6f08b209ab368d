#include "app/cli/console/InputOutput.h"
#include "app/cli/console/ProgressLine.h"
#include "app/cli/options/AssetOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/verbs/Verb.h"
#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/io/project/AssetDifferenceJson.h"

#include <algorithm>
#include <memory>

namespace rubble {
namespace {

constexpr const char* kDiffFooter =
    R"(Compares two saved states of a project, asset by asset: the changed properties (outline, depth, material,
threshold, layers, ...), and the fragments that were removed, added, moved or reshaped. Fragments are matched by
their ids, assets by their names, or by their ids if they were renamed. Exits with 0 if nothing differs, and
with 1 if something does, or if a file cannot be read; then nothing is printed to standard output.

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
std::string piecesText(const BakeDifference& difference, bool isAll) {
    std::string text;
    for (auto begin = difference.pieces.begin(); begin != difference.pieces.end();) {
        const auto end = std::ranges::find_if(begin, difference.pieces.end(), [&](const PieceDifference& piece) {
            return piece.change != begin->change;
        });
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
        return name + ": added, " + countText(difference.pieces.sum().after, "fragment", "fragments") + "\n";
    if (!pair.after)
        return name + ": removed, had " + countText(difference.pieces.sum().before, "fragment", "fragments") + "\n";
    std::string text = name + ": changed\n";
    for (const RecipeChange& change : difference.recipe) text += "  " + sentenceOf(change) + '\n';
    const std::vector<LevelDifference>& levels = difference.pieces.levels;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        text += (levels.size() > 1 ? "  level " + std::to_string(k) + ": " : "  ") + sentenceOf(levels[k]) + '\n';
    }
    return text + piecesText(difference.pieces, isAll);
}

/// Returns an error if something differs.
Status statusOf(std::span<const AssetDifference> differences) {
    const auto same = std::ranges::count_if(differences, &AssetDifference::isEmpty);
    const auto changed = static_cast<std::ptrdiff_t>(differences.size()) - same;
    if (changed == 0) return success();
    return Error{ErrorCode::BadInput, std::to_string(changed) + " of " + std::to_string(differences.size()) +
                                          (differences.size() == 1 ? " asset differs." : " assets differ.")};
}

Status diff(const DiffOptions& options, const CliContext& context) {
    const Result<Project> before = openProject(options.before, context);
    if (!before) return before.error();
    const Result<Project> after = openProject(options.after, context);
    if (!after) return after.error();
    const Result<std::vector<AssetPair>> pairs = selectedPairs(assetPairs(*before, *after), options.assets);
    if (!pairs) return pairs.error();
    const TaskContext task{.cancel = context.cancel, .threads = options.threads};
    ProgressLine line(context, "Comparing");
    std::vector<AssetDifference> differences;
    for (const AssetPair& pair : *pairs) {
        line.show(static_cast<double>(differences.size()) / static_cast<double>(pairs->size()));
        Result<AssetDifference> difference = differenceOf(*before, *after, pair, task);
        if (!difference) return difference.error();
        differences.push_back(std::move(*difference));
    }
    line.clear();
    std::string text;
    for (const AssetDifference& difference : differences) text += textOf(difference, options.isAll);
    const Status written = printText(options.isJson ? assetDifferenceJson(differences) : text, context);
    return written ? statusOf(differences) : written;
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
    return {command, [options](const CliContext& context) { return diff(*options, context); }};
}

}  // namespace rubble
