#pragma once

#include "core/asset/project/Project.h"
#include "core/fracture/partition/Partition.h"
#include "editor/document/Edit.h"
#include "editor/document/FragmentSelection.h"

#include <set>
#include <vector>

namespace rubble {

/// A selected fragment, as a piece of a pattern.
struct SelectedFragment {
    FragmentPath path;
    double area = 0.0;  // m²
    Line splitLine;     // through its centroid, perpendicular to its principal axis
};

/// The selected fragments of an asset's partition, in its order. `seeds` are all seeds of the partition, which
/// fractures the fragment `parent` (empty: the whole asset); `offset` (m) is the position of its frame in the asset's.
std::vector<SelectedFragment> selectedFragments(Id asset, const Partition& partition, const Seeds& seeds,
                                                const FragmentSelection& selection, const FragmentPath& parent = {},
                                                Vec2 offset = Vec2(0.0, 0.0));

/// The selected fragments of a bake below `parent` that have no selected ancestor.
std::vector<SelectedFragment> selectedFragments(const Bake& bake, const FragmentSelection& selection,
                                                const FragmentPath& parent = {});
/// The selected fragments of a bake that are deeper than the children of `parent` and have no selected ancestor.
std::vector<SelectedFragment> selectedDescendants(const Bake& bake, const FragmentSelection& selection,
                                                  const FragmentPath& parent = {});

/// The line through an outline's centroid, perpendicular to its principal axis; `origin` is added to it, m.
Line splitLine(const Polygon& outline, Vec2 origin);

/// Gives each fragment without a pattern of its own one: a few scattered seeds.
Edit fractureFragments(const Project& project, Id asset, const std::vector<SelectedFragment>& fragments);
/// Excludes the fragments from being fractured by their level.
Edit keepFragmentsWhole(const Project& project, Id asset, const std::vector<SelectedFragment>& fragments);
/// Merges fragments into the largest of them.
Edit mergeFragments(const Project& project, Id asset, const std::vector<SelectedFragment>& fragments);
/// Splits each fragment in two, across its longest dimension.
Edit splitFragments(const Project& project, Id asset, const std::vector<SelectedFragment>& fragments);

/// Sets the threshold of a single fragment, N·s; none: it follows from its level or its volume again.
void setFragmentThreshold(Asset& asset, const FragmentPath& fragment, std::optional<double> threshold);

/// Sets whether a single fragment of an asset that breaks as bonded never breaks.
void setNeverBreaks(Asset& asset, const FragmentPath& fragment, bool neverBreaks);

/// Removes all merges, splits, own patterns and other own settings of fragments that come from these seeds of the
/// pattern of `parent` (empty: the whole asset).
Edit restoreFragments(const Project& project, Id asset, const std::set<SeedId>& seeds, const FragmentPath& parent = {});
/// Whether restoreFragments() would remove anything.
bool canRestoreFragments(const Asset& asset, const std::set<SeedId>& seeds, const FragmentPath& parent = {});

}  // namespace rubble
