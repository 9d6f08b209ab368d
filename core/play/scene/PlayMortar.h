#pragma once

#include "core/play/scene/PlayStructure.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace rubble {

/// A bonded instance that mortar may join.
struct MortarMember {
    const Instance* instance = nullptr;
    std::shared_ptr<const PlayStructure> structure;  // of its whole, with its anchors
};

/// Joins instances by the mortars of a project: adds an anchor to the structures of both instances for each face that
/// they have in common, see mortarBonds(), and to one where the other is fixed and does not break along bonds.
/// Mortar holds what stands: of instances of which none is anchored, nothing is joined.
///
/// Replaces the structures of `members`. Returns the mortars that hold nothing, by name.
std::vector<std::string> addMortar(const Project& project, std::span<const FixedSolid> surroundings,
                                   std::map<Id, MortarMember>& members);

}  // namespace rubble
