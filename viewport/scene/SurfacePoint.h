#pragma once

#include "core/geometry/Ray.h"
#include "viewport/scene/Camera.h"
#include "viewport/scene/RenderScene.h"

#include <optional>

namespace rubble {

/// A point on what a scene shows.
struct SurfacePoint {
    std::uint32_t body = 0;     // as an index in RenderScene::picks
    Vec3 place{0.0, 0.0, 0.0};  // m, in the world
};

/// Where a ray enters the first body that is not hidden, where it is drawn: moved apart, if it is. Linear in corners.
/// Source: Möller, Trumbore 1997.
std::optional<SurfacePoint> surfaceAt(const RenderScene& scene, const Ray& ray);

/// The corner of a body that is seen nearest to a point of the picture (pixels from its top left corner), within `reach`
/// pixels and on a face that is turned towards the eye; of corners that are seen at one point the nearest one.
std::optional<Vec3> cornerNear(const RenderScene& scene, std::uint32_t body, const Camera& camera, PictureSize size,
                               Vec2 pixel, double reach);

}  // namespace rubble
