#pragma once

#include "core/play/scene/PlayStructure.h"

#include <map>
#include <span>
#include <vector>

namespace rubble {

/// A structure that mortar joins, as it stands.
struct JoinedStructure {
    const PlayStructure* structure = nullptr;
    std::span<const BondDamage> damage;  // of each bond
    std::vector<std::uint32_t> held;     // nodes, ascending
    Vec3 up{0.0};                        // in its frame, of length 1
};

/// Numbers of the nodes of structures, by instance.
using NodeFractions = std::map<Id, std::vector<double>>;

/// How far the held nodes of structures, by instance, are from what supports them, as fractions of the span of the
/// structure that each is in; infinite where no support reaches, and of what is not held.
///
/// Support spreads from the anchors that are none of mortar, as in anchorDistances(), with each distance as a fraction
/// of the span of the structure that it is in. Over mortar it goes on to what stands on a node, which has all of its
/// span from there; and sideways, with what is left of the span. What lies above a node does not support it: it would
/// be held by what it carries. A structure without a span is supported where it is held.
///
/// `limits`: up to which a node is supported, and passes support on; empty: at any distance. O(n log n) in the nodes
/// and their bonds.
NodeFractions supportFractions(const std::map<Id, JoinedStructure>& joined, const NodeFractions& limits = {});

/// A structure at the start, when all of its nodes are held.
JoinedStructure joinedAtStart(const PlayStructure& structure, Vec3 up);

/// The fractions up to which nodes are supported, by instance, given the structures at the start: 1, or the fraction
/// then where that is larger. What is beyond the span from the start so keeps the support that it has.
NodeFractions joinedSupportLimits(const std::map<Id, JoinedStructure>& atStart);

}  // namespace rubble
