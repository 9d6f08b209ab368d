#include "app/cli/options/AssetOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/project/Ranges.h"
#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/project/ProjectLock.h"
#include "core/structure/clusters/ClusterEditing.h"

#include <algorithm>
#include <memory>

namespace rubble {
namespace {

constexpr const char* kClustersFooter =
    R"(Parts the fragments of an asset that breaks along bonds into connected clusters of nearly the same size, which
come off as one and break apart afterwards, and saves the project. Replaces the clusters of --level; those of a deeper
level stay inside of those of the next coarser one. rubble-cli check tells where clusters do not fit the fragments.

Examples:
  rubble-cli clusters arcade.rubble --asset arcade --count 12
  rubble-cli clusters arcade.rubble --asset arcade --level 1 --size 4)";

struct ClustersOptions {
    std::string project;
    std::string asset;
    int level = 0;
    std::optional<int> count;
    std::optional<int> size;
};

std::string levelText(std::uint32_t level) { return "level " + std::to_string(level); }

/// The clusters of the level among all of an asset.
std::size_t countOf(const std::vector<FragmentCluster>& clusters, std::uint32_t level) {
    return static_cast<std::size_t>(std::ranges::count(clusters, level, &FragmentCluster::level));
}

Status propose(const ClustersOptions& options, VerbReport& report, const CliContext& context) {
    if (options.count.value_or(options.size.value_or(0)) == 0)
        return Error{ErrorCode::BadInput, "There must be one cluster or more, of one fragment or more."};
    const Result<std::shared_ptr<const LockFile>> lock = waitForProjectLock(options.project, context.cancel);
    if (!lock) return lock.error();
    Result<Project> project = openProject(options.project, context);
    if (!project) return project.error();
    const Result<std::vector<Id>> selected = selectedAssets(*project, {options.asset});
    if (!selected) return selected.error();
    Asset& asset = *std::ranges::find(project->assets, selected->front(), &Asset::id);
    if (asset.breakAs != BreakAs::Bonded) {
        return Error{ErrorCode::BadInput,
                     "The asset " + quotedName(asset.name) + " breaks whole; only bonded assets have clusters."};
    }
    const Result<Bake> baked = bake(asset, {.cancel = context.cancel});
    if (!baked) return baked.error();
    if (baked->fractureOf(kNone) == nullptr) {
        return Error{ErrorCode::BadInput, "The asset " + quotedName(asset.name) + " has fewer than two fragments."};
    }
    const auto level = static_cast<std::uint32_t>(options.level);
    ClusterTarget target{.value = static_cast<std::uint32_t>(options.count.value_or(options.size.value_or(0)))};
    if (options.size) target.measure = ClusterTarget::Measure::Size;
    asset.bonding.clusters = ClusterEditing(asset, *baked, 0, level).propose(target);
    const std::size_t count = countOf(asset.bonding.clusters, level);
    const std::string sentence =
        quotedName(asset.name) + " has " + countText(count, "cluster", "clusters") + " of " + levelText(level) + ".";
    if (const Status saved = saveProject(options.project, *project); !saved) return saved.error();
    return printSummary(sentence + "\nSaved " + options.project + "\n", report, context);
}

}  // namespace

Verb addClusters(CLI::App& program) {
    Command command(program, "clusters", "Propose clusters of a bonded asset's fragments", kClustersFooter);
    const auto options = std::make_shared<ClustersOptions>();
    addProjectArgument(command, options->project);
    command.option("--asset", options->asset, "The asset").required().valueName("NAME");
    command.option("--level", options->level, "The level of clusters: 0 (default), the coarsest, breaks first")
        .wholeInRange(ProjectNumber::BondClusterLevel)
        .valueName("N");
    const CommandOption count = command.option("--count", options->count, "The number of clusters")
                                    .wholeUpTo(ClusterTarget::kMost)
                                    .valueName("N");
    const CommandOption size = command.option("--size", options->size, "The number of fragments of each")
                                   .wholeUpTo(ClusterTarget::kMost)
                                   .valueName("N")
                                   .excludes(count);
    command.requireOne(count, size);
    return {command,
            [options](VerbReport& report, const CliContext& context) { return propose(*options, report, context); }};
}

}  // namespace rubble
