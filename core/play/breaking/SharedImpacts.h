#pragma once

#include "core/physics/world/World.h"

#include <span>
#include <vector>

namespace rubble {

/// The impacts of a step, sorted by bodies as World::impacts() gives them, where one body may have several: what hits
/// two others shares its impulse among them. Their impulses together stop all approaches and cause the restitution,
/// where each alone would take all that the body has; only Impact::effectiveMass changes. Of two bodies that meet at
/// several manifolds, the strongest impact is theirs. Equal impacts share equally, whatever their order.
///
/// O(n) for n impacts.
/// Source: Moreau 1988, "Unilateral contact and dry friction in finite freedom dynamics": simultaneous impacts as a
/// linear complementarity problem; here by projected Jacobi iterations.
std::vector<Impact> sharedImpacts(const World& world, std::span<const Impact> impacts);

}  // namespace rubble
