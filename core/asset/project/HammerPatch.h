#pragma once

#include "core/asset/project/Project.h"

namespace rubble {

/// The speed of the head of a hammer, m/s: a sledgehammer's is 10 to 20. A blow of J N·s is that of a head of
/// J / kHammerSpeed kg: it has an energy of J kHammerSpeed / 2, and makes nothing faster than itself.
inline constexpr double kHammerSpeed = 20.0;

/// The radius of the patch that a blow strikes, m: its own, or that of a steel ball of the head's mass, within its
/// range.
double patchRadius(const Hammer& hammer);

}  // namespace rubble
