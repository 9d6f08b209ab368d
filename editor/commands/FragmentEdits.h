#pragma once

#include "core/asset/Project.h"
#include "core/fracture/Partition.h"
#include "editor/document/Edit.h"

#include <set>
#include <vector>

namespace rubble {

/// A piece of an asset's pattern as it is chosen in the canvas.
struct ChosenPiece {
    FragmentPath path;
    double area = 0.0;  // m^2
    Line across;        // through its centre, across its longest way
};

/// The pieces that come from some seeds, in the order of the partition. `seeds` are those of the partition, which is of the whole or of
/// the fragment `inside`, whose frame stands at `offset` (m) in the asset's.
std::vector<ChosenPiece> chosenPieces(const Partition& partition, const Seeds& seeds, const std::set<SeedId>& chosen,
                                      const FragmentPath& inside = {}, Vec2 offset = Vec2(0.0, 0.0));

/// Through the middle of an outline, across its longest way; `origin` is where the outline's own stands, m.
Line lineAcross(const Polygon& outline, Vec2 origin);

/// Each of these fragments is broken by a pattern of its own from now on: a few scattered seeds to begin with, as long as it has none.
Edit fractureFragments(const Project& project, Id asset, const std::vector<ChosenPiece>& pieces);
/// They stay whole, whatever their level says.
Edit keepFragmentsWhole(const Project& project, Id asset, const std::vector<ChosenPiece>& pieces);
/// Merges fragments into the largest of them.
Edit mergeFragments(const Project& project, Id asset, const std::vector<ChosenPiece>& pieces);
/// Cuts each fragment in two, across its longest way.
Edit splitFragments(const Project& project, Id asset, const std::vector<ChosenPiece>& pieces);

/// Takes back all merges and splits of pieces of these seeds, which break the whole or the fragment `inside`, and what makes them break
/// in their own way.
Edit restoreFragments(const Project& project, Id asset, const std::set<SeedId>& seeds, const FragmentPath& inside = {});
/// Whether there is anything to take back.
bool areRestorable(const Asset& asset, const std::set<SeedId>& seeds, const FragmentPath& inside = {});

}  // namespace rubble
