#pragma once

#include "core/geometry/Polygon.h"
#include "viewport/scene/Camera.h"
#include "viewport/scene/RenderScene.h"

namespace rubble {

/// The bodies that are not hidden and whose middle is seen within a box of the picture (pixels from its top left corner),
/// in front or behind others; ascending, as indices in RenderScene::picks. `moment`: as in PictureView. Linear in bodies.
std::vector<std::uint32_t> bodiesWithin(const RenderScene& scene, const Camera& camera, PictureSize size,
                                        const Box2& pixels, double moment = 1.0);

}  // namespace rubble
