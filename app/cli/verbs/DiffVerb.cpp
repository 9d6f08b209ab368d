#include "app/cli/console/InputOutput.h"
#include "app/cli/console/ProgressLine.h"
#include "app/cli/options/AssetOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/output/PackDifference.h"
#include "app/cli/output/PackFolders.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/verbs/Verb.h"
#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/io/project/ProjectDifferenceJson.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace rubble {
namespace {

constexpr const char* kDiffFooter =
    R"(Compares two saved states of a project. Of each asset: the changed properties (outline, depth, material,
threshold, layers, ...), and the fragments that were removed, added, moved or reshaped. Fragments are matched by
their ids, assets by their names, or by their ids if they were renamed. Then, without --asset, everything else
that a project holds: materials, instances, ground, gravity, damage, debris, shots and tests, matched by id or
name. Also compares two packs, or two folders of packs, field by field: fragments are matched by their ids, and
packs by the names of their folders. Exits with 0 if nothing differs, with 3 if something does, and with 1 if a
file cannot be read.

Examples:
  rubble-cli diff before.rubble house.rubble
  rubble-cli diff before.rubble house.rubble --asset wall --all
  rubble-cli diff before.rubble house.rubble --json
  rubble-cli diff packs-of-yesterday packs)";

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

/// Whether a path is that of a pack, or of a folder, which may hold packs.
bool isOfPacks(const std::filesystem::path& path) {
    std::error_code ignored;  // reading will report the error
    return std::filesystem::is_directory(path, ignored) || path.filename() == kPackName;
}

/// The folders of packs by the names by which they are matched. A single pack has none, so that it is compared with any
/// other.
///
/// Errors: those of packsOf().
Result<std::map<std::string, std::filesystem::path>> namedPacks(std::filesystem::path path) {
    if (path.filename() == kPackName) path = path.has_parent_path() ? path.parent_path() : ".";
    const Result<std::vector<std::filesystem::path>> packs = packsOf(path);
    if (!packs) return packs.error();
    std::map<std::string, std::filesystem::path> named;
    for (const std::filesystem::path& pack : *packs)
        named.emplace(pack == path ? std::string() : pack.filename().string(), pack);
    return named;
}

/// Errors: those of loadExportedPack().
Result<PackDifference> differenceOfFolders(const std::filesystem::path* before, const std::filesystem::path* after) {
    std::optional<ExportedPack> packs[2];
    const std::filesystem::path* folders[2] = {before, after};
    for (int k = 0; k < 2; ++k) {
        if (folders[k] == nullptr) continue;
        Result<ExportedPack> pack = loadExportedPack(*folders[k]);
        if (!pack) return pack.error();
        packs[k] = std::move(*pack);
    }
    return packDifference(packs[0] ? &*packs[0] : nullptr, packs[1] ? &*packs[1] : nullptr);
}

Status diffPacks(const DiffOptions& options, VerbReport& report, const CliContext& context) {
    for (const std::string& path : {options.before, options.after}) {
        std::error_code ignored;  // a path that cannot be looked at is read, which fails
        if (!std::filesystem::exists(std::filesystem::symlink_status(path, ignored)))
            return Error{ErrorCode::NotFound, "There is no file or folder " + quotedPath(path) + "."};
    }
    if (!isOfPacks(options.before) || !isOfPacks(options.after)) {
        return Error{ErrorCode::BadInput,
                     "A project and a pack cannot be compared; give two projects, two packs or two "
                     "folders of packs."};
    }
    if (!options.assets.empty()) {
        return Error{ErrorCode::BadInput, "--asset selects assets of projects; give the folders of two packs instead."};
    }
    const auto before = namedPacks(options.before), after = namedPacks(options.after);
    if (!before) return before.error();
    if (!after) return after.error();
    if (before->contains("") != after->contains("")) {
        return Error{ErrorCode::BadInput, "A pack and a folder of packs cannot be compared; give two of a kind."};
    }
    std::map<std::string, std::pair<const std::filesystem::path*, const std::filesystem::path*>> pairs;
    for (const auto& [name, folder] : *before) pairs[name].first = &folder;
    for (const auto& [name, folder] : *after) pairs[name].second = &folder;
    std::vector<PackDifference> differences;
    std::string text;
    for (const auto& [name, pair] : pairs) {
        if (context.cancel.isCancelled()) return TaskContext::cancelled();
        Result<PackDifference> difference = differenceOfFolders(pair.first, pair.second);
        if (!difference) return difference.error();
        text += packDifferenceText(*difference, options.isAll ? std::string::npos : kMaxListed);
        differences.push_back(std::move(*difference));
    }
    const auto changed = static_cast<std::size_t>(std::ranges::count_if(
        differences, [](const PackDifference& difference) { return difference.change.has_value(); }));
    if (changed > 0) {
        conclude(report, std::to_string(changed) + " of " + countText(differences.size(), "pack", "packs") +
                             (differences.size() == 1 ? " differs." : " differ."));
    }
    return printText(options.isJson ? packDifferencesJson(differences) : text, context);
}

Status diff(const DiffOptions& options, VerbReport& report, const CliContext& context) {
    if (isOfPacks(options.before) || isOfPacks(options.after)) return diffPacks(options, report, context);
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
    Command command(program, "diff", "Compare two saved states of a project, or two exports", kDiffFooter);
    const auto options = std::make_shared<DiffOptions>();
    command.argument("BEFORE", options->before, "The project, pack or folder of packs before the change").required();
    command.argument("AFTER", options->after, "The one after the change").required();
    addAssetOption(command, options->assets);
    command.flag("--all", options->isAll, "List every fragment, not only the first ten of each change");
    addJsonOption(command, options->isJson);
    addThreadsOption(command, options->threads);
    return {command,
            [options](VerbReport& report, const CliContext& context) { return diff(*options, report, context); }};
}

}  // namespace rubble
