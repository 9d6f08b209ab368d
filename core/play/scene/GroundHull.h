#pragma once

#include "core/geometry/hull/Polytope.h"

#include <memory>

namespace rubble {

/// The box that is the ground, its top at height 0. It reaches farther than any body can be, kMaxCoordinate.
std::shared_ptr<const Polytope> groundHull();

}  // namespace rubble
