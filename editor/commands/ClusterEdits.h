#pragma once

#include "core/base/Result.h"
#include "core/structure/clusters/ClusterEditing.h"
#include "editor/document/Edit.h"
#include "editor/document/FragmentSelection.h"

namespace rubble {

/// What is done with the selected fragments of a bonded asset, or with the clusters that they are in.
enum class ClusterCommand { Make, Grow, Merge, Split, Remove };

/// The edit that a command is at a level. Only fragments of one parent can be in a cluster.
///
/// Errors: BadInput with a sentence for the status bar if the command does not apply to the selection.
Result<Edit> clusterEdit(const Asset& asset, const Bake& bake, const FragmentSelection& selection,
                         ClusterCommand command, std::uint32_t level);

/// The edit that replaces the clusters of a level by proposed ones: of the fragments of `parent` (empty: the whole).
///
/// Errors: BadInput with a sentence if it has fewer than two fragments.
Result<Edit> proposeClusters(const Asset& asset, const Bake& bake, const FragmentPath& parent, std::uint32_t level,
                             const ClusterTarget& target);

/// The edit that removes all clusters of a level of the fragments of `parent`; nothing if there are none.
std::optional<Edit> clearClusters(const Asset& asset, const FragmentPath& parent, std::uint32_t level);

/// The selection of the fragments of a cluster, as far as the bake has them.
FragmentSelection selectionOfCluster(const Bake& bake, const FragmentCluster& cluster,
                                     const FragmentPath& enteredFragment);

}  // namespace rubble
