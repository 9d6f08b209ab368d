#pragma once

#include "core/geometry/hull/Polytope.h"

#include <memory>

namespace rubble {

/// The box that is the ground, its top at height 0.
std::shared_ptr<const Polytope> groundHull();

}  // namespace rubble
