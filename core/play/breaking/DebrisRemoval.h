#pragma once

#include "core/play/state/SessionState.h"

#include <cstddef>

namespace rubble {

/// How far a body has faded out, in [0, 1].
double fadeOf(const PlayBody& body, const Debris& debris, std::uint64_t step, double dt);
/// Removes debris that has faded out or exceeds Debris::maxFragments, and bodies that have left the world.
/// Returns the number of bodies visited, a measure of its work that does not depend on the machine.
std::size_t removeDebris(SessionParts& parts);

}  // namespace rubble
