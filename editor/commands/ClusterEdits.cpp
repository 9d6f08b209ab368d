#include "editor/commands/ClusterEdits.h"

#include "core/asset/bake/FragmentLookup.h"
#include "editor/commands/ProjectEdits.h"

#include <QCoreApplication>

#include <algorithm>

namespace rubble {

namespace {

struct ClusterEditsTexts {
    Q_DECLARE_TR_FUNCTIONS(ClusterEdits)
};

Error refusal(const QString& sentence) { return {ErrorCode::BadInput, sentence.toStdString()}; }

/// Fragments of one fracture.
struct FragmentNodes {
    std::uint32_t fracture = 0;
    std::vector<std::uint32_t> nodes;  // ascending
};

Result<FragmentNodes> selectedNodes(const Bake& bake, const FragmentSelection& selection) {
    const std::vector<std::uint32_t> roots = rootsOf(bake, fragmentsOf(selection, bake));
    if (roots.empty()) return refusal(ClusterEditsTexts::tr("No fragment is selected. Select fragments first."));
    FragmentNodes found{.fracture = bake.fractureContaining(roots.front()), .nodes = {}};
    for (const std::uint32_t root : roots) {
        if (bake.fractureContaining(root) != found.fracture) {
            return refusal(ClusterEditsTexts::tr(
                "The selected fragments have different parents. Select fragments of one parent."));
        }
        found.nodes.push_back(root - bake.fractures[found.fracture].first);
    }
    return found;
}

Edit clustersEdit(const QString& text, const Asset& asset, std::vector<FragmentCluster> clusters) {
    Asset changed = asset;
    changed.bonding.clusters = std::move(clusters);
    return modify(text, std::move(changed));
}

/// Whether fragments lie in one cluster of the next coarser level, or all in none.
bool areWithinOne(const ClusterEditing& editing, const std::vector<std::uint32_t>& nodes) {
    const std::vector<std::uint32_t> coarser = editing.coarserClusters();
    return std::ranges::all_of(nodes, [&](std::uint32_t node) { return coarser[node] == coarser[nodes.front()]; });
}

Result<Edit> makeEdit(const Asset& asset, const ClusterEditing& editing, const std::vector<std::uint32_t>& nodes) {
    if (nodes.size() < 2)
        return refusal(ClusterEditsTexts::tr("One fragment is selected. A cluster has two at least."));
    if (!areWithinOne(editing, nodes)) {
        return refusal(ClusterEditsTexts::tr(
            "The selected fragments are in different coarser clusters. Select fragments of one of them."));
    }
    return clustersEdit(ClusterEditsTexts::tr("Make Cluster"), asset, editing.make(nodes));
}

/// The edit of a command on the clusters that fragments are in.
Result<Edit> editOf(ClusterCommand command, const Asset& asset, const ClusterEditing& editing,
                    const std::vector<std::uint32_t>& nodes, std::uint32_t level) {
    const std::vector<std::uint32_t> clusters = editing.clustersOf(nodes);
    if (clusters.empty()) {
        return refusal(ClusterEditsTexts::tr("None of the selected fragments is in a cluster of level %1.").arg(level));
    }
    switch (command) {
        case ClusterCommand::Grow: {
            std::vector<FragmentCluster> grown = editing.grow(clusters);
            if (grown != asset.bonding.clusters)
                return clustersEdit(ClusterEditsTexts::tr("Grow Cluster"), asset, std::move(grown));
            return refusal(ClusterEditsTexts::tr("The clusters have no neighbours that are in no other cluster."));
        }
        case ClusterCommand::Merge: {
            if (clusters.size() < 2)
                return refusal(
                    ClusterEditsTexts::tr("The selected fragments are in one cluster. Select fragments of "
                                          "the clusters to merge."));
            std::vector<std::uint32_t> first;
            for (const std::uint32_t cluster : clusters) first.push_back(editing.nodesOf(cluster).front());
            if (!areWithinOne(editing, first)) {
                return refusal(ClusterEditsTexts::tr(
                    "The selected clusters are in different coarser clusters. Merge these first."));
            }
            return clustersEdit(ClusterEditsTexts::tr("Merge Clusters"), asset, editing.merge(clusters));
        }
        case ClusterCommand::Split:
            return clustersEdit(ClusterEditsTexts::tr("Split Clusters"), asset, editing.split(clusters));
        case ClusterCommand::Make:
        case ClusterCommand::Remove: break;
    }
    return clustersEdit(ClusterEditsTexts::tr("Remove from Clusters"), asset, editing.remove(nodes));
}

}  // namespace

Result<Edit> clusterEdit(const Asset& asset, const Bake& bake, const FragmentSelection& selection,
                         ClusterCommand command, std::uint32_t level) {
    const Result<FragmentNodes> selected = selectedNodes(bake, selection);
    if (!selected) return selected.error();
    const ClusterEditing editing(asset, bake, selected->fracture, level);
    return command == ClusterCommand::Make ? makeEdit(asset, editing, selected->nodes)
                                           : editOf(command, asset, editing, selected->nodes, level);
}

Result<Edit> proposeClusters(const Asset& asset, const Bake& bake, const FragmentPath& parent, std::uint32_t level,
                             const ClusterTarget& target) {
    const std::optional<std::uint32_t> whole = fragmentAt(bake, parent);
    const BakedFracture* fracture = whole ? bake.fractureOf(*whole) : nullptr;
    if (fracture == nullptr || fracture->fragments.count() < 2)
        return refusal(ClusterEditsTexts::tr("There are fewer than two fragments to put into clusters."));
    const auto index = static_cast<std::uint32_t>(fracture - bake.fractures.data());
    return clustersEdit(ClusterEditsTexts::tr("Propose Clusters"), asset,
                        ClusterEditing(asset, bake, index, level).propose(target));
}

std::optional<Edit> clearClusters(const Asset& asset, const FragmentPath& parent, std::uint32_t level) {
    std::vector<FragmentCluster> kept = asset.bonding.clusters;
    const auto isCleared = [&](const FragmentCluster& cluster) {
        return cluster.level == level && parentOf(cluster.fragments.front()) == parent;
    };
    if (std::erase_if(kept, isCleared) == 0) return std::nullopt;
    return clustersEdit(ClusterEditsTexts::tr("Clear Clusters"), asset, std::move(kept));
}

FragmentSelection selectionOfCluster(const Bake& bake, const FragmentCluster& cluster,
                                     const FragmentPath& enteredFragment) {
    FragmentSet set(bake.fragmentCount(), false);
    for (const FragmentPath& path : cluster.fragments) {
        const std::optional<std::uint32_t> fragment = fragmentAt(bake, path);
        if (fragment && *fragment != kNone) set[*fragment] = true;
    }
    return selectionOf(withDescendants(bake, set), bake, enteredFragment);
}

}  // namespace rubble
