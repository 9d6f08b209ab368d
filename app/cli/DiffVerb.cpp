#include "app/cli/ChosenAssets.h"
#include "app/cli/CommonOptions.h"
#include "app/cli/ProgressLine.h"
#include "app/cli/Verb.h"
#include "core/io/DifferenceJson.h"
#include "core/io/ProjectFile.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(Two saved states of a project are compared asset by asset: what each says otherwise (outline, depth, material, threshold,
layers, …), and, as both are broken, which fragments are gone, added, moved or of another shape. Fragments are found by
their ids, assets by their names, or by their ids where they were renamed. The exit status is 0 where nothing differs and 1
where something does, or where a file cannot be read; then nothing is printed to standard output.

Examples:
  rubble-cli diff before.rubble house.rubble
  rubble-cli diff before.rubble house.rubble --asset wall --all
  rubble-cli diff before.rubble house.rubble --json)";

constexpr std::size_t kMostListed = 10;  // fragments of each change that are named one by one, unless all are

struct DiffOptions {
    std::string before;
    std::string after;
    std::vector<std::string> assets;
    bool isAll = false;
    bool isJson = false;
    int threads = 1;
};

/// The pairs with these names; all where there is no name.
Result<std::vector<AssetPair>> chosenPairs(std::vector<AssetPair> pairs, const std::vector<std::string>& names) {
    const auto isCalled = [](const AssetPair& pair, const std::string& name) {
        return (pair.before && pair.before->name == name) || (pair.after && pair.after->name == name);
    };
    for (const std::string& name : names) {
        if (std::ranges::any_of(pairs, [&](const AssetPair& pair) { return isCalled(pair, name); })) continue;
        return Error{ErrorCode::NotFound, "Neither project has an asset \"" + name + "\"."};
    }
    std::erase_if(pairs, [&](const AssetPair& pair) {
        return !names.empty() &&
               std::ranges::none_of(names, [&](const std::string& name) { return isCalled(pair, name); });
    });
    return pairs;
}

/// The fragments of one change after another, each on a line; not more than some of them, unless all are asked for.
std::string piecesText(const BakeDifference& difference, bool isAll) {
    std::string text;
    for (auto begin = difference.pieces.begin(); begin != difference.pieces.end();) {
        const auto end = std::ranges::find_if(begin, difference.pieces.end(), [&](const PieceDifference& piece) {
            return piece.change != begin->change;
        });
        const auto count = static_cast<std::size_t>(end - begin);
        const std::size_t listed = isAll ? count : std::min(count, kMostListed);
        for (std::size_t k = 0; k < listed; ++k) text += "  " + sentenceOf(*begin++) + '\n';
        if (listed < count) text += "  … and " + std::to_string(count - listed) + " more; --all names them\n";
        begin = end;
    }
    return text;
}

std::string textOf(const AssetDifference& difference, bool isAll) {
    const AssetPair& pair = difference.pair;
    const std::string& name = pair.name();
    if (difference.isNone()) return name + ": same\n";
    if (!pair.before) return name + ": new, " + std::to_string(difference.pieces.sum().after) + " fragments\n";
    if (!pair.after) return name + ": gone, had " + std::to_string(difference.pieces.sum().before) + " fragments\n";
    std::string text = name + ": changed\n";
    for (const RecipeChange& change : difference.recipe) text += "  " + sentenceOf(change) + '\n';
    const std::vector<LevelDifference>& levels = difference.pieces.levels;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        text += (levels.size() > 1 ? "  level " + std::to_string(k) + ": " : "  ") + sentenceOf(levels[k]) + '\n';
    }
    return text + piecesText(difference.pieces, isAll);
}

/// A sentence where something differs.
Status verdictOn(std::span<const AssetDifference> differences) {
    const auto same = std::ranges::count_if(differences, &AssetDifference::isNone);
    const auto changed = static_cast<std::ptrdiff_t>(differences.size()) - same;
    if (changed == 0) return success();
    return Error{ErrorCode::BadInput, std::to_string(changed) + " of " + std::to_string(differences.size()) +
                                          (differences.size() == 1 ? " asset differs." : " assets differ.")};
}

Status diff(const DiffOptions& options, const CliContext& context) {
    const Result<Project> before = loadProject(options.before);
    if (!before) return before.error();
    const Result<Project> after = loadProject(options.after);
    if (!after) return after.error();
    const Result<std::vector<AssetPair>> pairs = chosenPairs(assetPairs(*before, *after), options.assets);
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
    const Status written = writeOutput("-", options.isJson ? differenceJson(differences) : text, context);
    return written ? verdictOn(differences) : written;
}

}  // namespace

Verb addDiff(CLI::App& program) {
    CLI::App* command = program.add_subcommand("diff", "Tell what changed between two saved states of a project");
    const auto options = std::make_shared<DiffOptions>();
    command->footer(kFooter);
    command->add_option("BEFORE", options->before, "The earlier state")->required()->type_name("");
    command->add_option("AFTER", options->after, "The later state")->required()->type_name("");
    addAssetOption(*command, options->assets);
    command->add_flag("--all", options->isAll, "Name every fragment, not the first ten of each change");
    command->add_flag("--json", options->isJson, "For programs: JSON instead of text");
    addThreadsOption(*command, options->threads);
    return {command, [options](const CliContext& context) { return diff(*options, context); }};
}

}  // namespace rubble
