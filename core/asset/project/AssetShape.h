#pragma once

#include "core/asset/project/Project.h"
#include "core/geometry/search/Box3.h"

namespace rubble {

/// The box around an asset, m, in its frame.
Box3 boundsOf(const Asset& asset);
/// Its size along each axis, m.
Vec3 sizeOf(const Asset& asset);
/// The box around its outline, or around the mesh that it is seen along z, m.
Box2 planeBoundsOf(const Asset& asset);
/// m³.
double volumeOf(const Asset& asset);

}  // namespace rubble
