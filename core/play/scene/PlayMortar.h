#pragma once

#include "core/play/scene/PlayStructure.h"

#include <array>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace rubble {

/// A bonded instance that mortar may join.
struct MortarMember {
    const Instance* instance = nullptr;
    std::shared_ptr<const PlayStructure> structure;  // of its whole, with its anchors
};

/// A face at which mortar joins fragments of two instances.
struct MortarJoint {
    Id first = 0;   // instances
    Id second = 0;  // 0: a fixed one that does not break along bonds
    // The fragment of each that it joins: a node of the structure; kNone: of what is fixed.
    std::array<std::uint32_t, 2> nodes{kNone, kNone};
    double area = 0.0;   // m²
    Vec3 centroid{0.0};  // m, in the world
    Vec3 normal{0.0};    // of length 1, from the first to the second
    Mat3 moments{0.0};   // m⁴: see Bond::moments
};

/// The joints of a mortar.
struct JoinedMortar {
    Id mortar = 0;
    std::vector<MortarJoint> joints;  // without those of earlier mortars
    bool isHeld = false;              // one of its instances is anchored, by itself or through mortar
};

/// The groups of instances that mortar joins with each other, PlayStructure::joined, in which some instances are; by
/// their first instance. What happens in one changes nothing of how others are held.
using JoinedGroups = std::map<Id, std::shared_ptr<const std::vector<Id>>>;
JoinedGroups joinedGroups(const std::map<Id, std::shared_ptr<const PlayStructure>>& structures,
                          const std::set<Id>& instances);

/// Joins instances by the mortars of a project: adds an anchor to the structures of both instances for each face that
/// they have in common, see mortarBonds(), and to one where the other is fixed and does not break along bonds.
/// Mortar holds what stands: of instances of which none is anchored, nothing is joined.
///
/// Replaces the structures of `members`. Returns what each mortar of the project joins, in its order.
///
/// Errors: Limit if the mortars together look at more than kMaxMortarPairs fragments and pairs of fragments that are
/// near each other: those of 200 walls in one place, or a thousand mortars that join everything. Nothing changes then.
Result<std::vector<JoinedMortar>> addMortar(const Project& project, std::span<const FixedSolid> surroundings,
                                            std::map<Id, MortarMember>& members);
/// Some seconds, and 500 MB.
inline constexpr std::size_t kMaxMortarPairs = 2'000'000;

}  // namespace rubble
