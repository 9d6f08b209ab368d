#pragma once

#include "core/physics/World.h"
#include "core/play/PlayBody.h"

namespace rubble {

/// How high the highest point of a body lies in the world, m.
double topOf(const PlayBody& body, const World& world);

}  // namespace rubble
