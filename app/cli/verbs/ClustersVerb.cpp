#include "app/cli/options/AssetOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/project/Ranges.h"
#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/structure/clusters/ClusterEditing.h"

#include <algorithm>
#include <memory>
#include <ostream>

namespace rubble {
namespace {

constexpr const char* kClustersFooter =
    R"(Parts the fragments of an asset that breaks along bonds into connected clusters of nearly the same size, which
come off as one and break apart afterwards, and saves the project. Replaces the clusters of --level; those of a deeper
level stay inside of those of the next coarser one. rubble-cli check reports where clusters do not fit the fragments.

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

/// Proposes the clusters of a level of an asset. Returns their number.
Result<std::size_t> propose(Asset& asset, std::uint32_t level, const ClusterTarget& target, const CliContext& context) {
    if (asset.breakAs != BreakAs::Bonded) {
        return Error{ErrorCode::BadInput,
                     "The asset " + quotedName(asset.name) + " breaks whole; only bonded assets have clusters."};
    }
    const Result<Bake> baked = bake(asset, {.cancel = context.cancel});
    if (!baked) return baked.error();
    if (baked->fractureOf(kNone) == nullptr)
        return Error{ErrorCode::BadInput, "The asset " + quotedName(asset.name) + " has fewer than two fragments."};
    std::vector<FragmentCluster> clusters = ClusterEditing(asset, *baked, 0, level).propose(target);
    asset.bonding.clusters = std::move(clusters);
    return static_cast<std::size_t>(std::ranges::count(asset.bonding.clusters, level, &FragmentCluster::level));
}

Status proposeClusters(const ClustersOptions& options, VerbReport& report, const CliContext& context) {
    ClusterTarget target{.value = static_cast<std::uint32_t>(options.count.value_or(options.size.value_or(0)))};
    if (options.size) target.measure = ClusterTarget::Measure::Size;
    if (target.value == 0)
        return Error{ErrorCode::BadInput, "There must be one cluster or more, of one fragment or more."};
    std::size_t count = 0;
    const Status saved = changeAsset(options.project, options.asset, context, [&](Project&, Asset& asset) -> Status {
        const Result<std::size_t> made = propose(asset, static_cast<std::uint32_t>(options.level), target, context);
        if (!made) return made.error();
        count = *made;
        if (count == 0) {
            return Error{ErrorCode::BadInput,
                         "The clusters would have one fragment each, which is none at all; ask for "
                         "fewer, or for larger ones."};
        }
        return success();
    });
    if (!saved) return saved;
    if (options.count && count < target.value) {
        context.err << "There are " << countText(count, "cluster", "clusters")
                    << " only, since one of a single fragment is none.\n";
    }
    return printSummary(quotedName(options.asset) + " has " + countText(count, "cluster", "clusters") + " of level " +
                            std::to_string(options.level) + ".\nSaved " + options.project + "\n",
                        report, context);
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
    return {command, [options](VerbReport& report, const CliContext& context) {
                return proposeClusters(*options, report, context);
            }};
}

}  // namespace rubble
