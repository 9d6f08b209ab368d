#pragma once

#include "core/physics/solver/SolverKernels.h"
#include "core/physics/state/WorldState.h"

#include <compare>
#include <span>
#include <vector>

namespace rubble {

using BlockList = std::vector<const ContactBlock*>;

/// A body that carries more than its own mass.
struct Load {
    float mass = 0.0f;  // kg, that it carries
    std::uint32_t body = 0;
    std::uint32_t source = 0;  // the heavy body, or one of them, whose mass it is
    auto operator<=>(const Load&) const = default;
};

/// The bodies that stand between the ground and a heavy body, ascending, with their loads. Followed are the loads of
/// bodies that touch one of less than 1 / kMaxLoadRatio of their mass: where a body rests on others, each of them
/// carries an equal part of its mass, or of what it carries itself if that is more. Bodies that fall carry nothing, nor
/// do those that are faster than overlaps are resolved, or whose load passes as fast. `unequal`: the blocks with such
/// bodies, as prepareContacts() lists them, in any order.
std::vector<Load> findLoads(const WorldState& state, std::span<const BlockList> unequal, const SolverStep& step);

}  // namespace rubble
