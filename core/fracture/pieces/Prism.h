#pragma once

#include "core/base/Result.h"
#include "core/geometry/polygon/Polygon.h"

namespace rubble {

/// A solid: an outline in the local xy plane, extruded to z in [-depth/2, depth/2].
struct Prism {
    Polygon outline;     // m
    double depth = 1.0;  // m, > 0
    bool operator==(const Prism&) const = default;
};

/// The prism with its outline in canonical winding.
///
/// Errors: those of validated(Polygon); BadInput if the depth is not finite, zero, negative or out of range.
Result<Prism> validated(Prism prism);

}  // namespace rubble
