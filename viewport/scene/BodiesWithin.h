#pragma once

#include "core/geometry/polygon/Polygon.h"
#include "viewport/scene/Camera.h"
#include "viewport/scene/RenderScene.h"

namespace rubble {

/// The visible bodies whose centre projects into a rectangle of the image (pixels from its top left corner), occluded
/// or not; ascending indices in RenderScene::picks. `stepFraction`: as in RenderView. Linear in bodies.
std::vector<std::uint32_t> bodiesWithin(const RenderScene& scene, const Camera& camera, ImageSize size,
                                        const Box2& pixels, double stepFraction = 1.0);

}  // namespace rubble
