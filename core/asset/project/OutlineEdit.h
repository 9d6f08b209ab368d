#pragma once

#include "core/asset/project/Project.h"

namespace rubble {

/// The asset with another outline, in canonical winding. Its scattered seeds stay where they are if they lie in it:
/// their layers keep the outline that they were scattered in.
Asset withOutline(Asset asset, Polygon outline);

}  // namespace rubble
