#pragma once

#include "core/geometry/hull/Ray.h"
#include "viewport/scene/Camera.h"
#include "viewport/scene/RenderScene.h"

#include <optional>

namespace rubble {

/// A point on a body's surface.
struct SurfaceHit {
    std::uint32_t body = 0;     // index in RenderScene::picks
    Vec3 point{0.0, 0.0, 0.0};  // m, in the world
};

/// The first hit of a ray with a visible body as drawn: exploded, if it is, and at a fraction of the step that led to
/// the scene. Linear in bodies, and in the triangles of those whose boxes the ray meets before it.
/// Source: Möller, Trumbore, "Fast, minimum storage ray/triangle intersection", 1997.
std::optional<SurfaceHit> surfaceHit(const RenderScene& scene, const Ray& ray, double stepFraction = 1.0);

/// The vertex of a body whose projection is nearest to a point of the image (pixels from its top left corner), within
/// `radius` pixels and on a front face; of vertices that project to the same point, the one nearest to the eye.
std::optional<Vec3> cornerNear(const RenderScene& scene, std::uint32_t body, const Camera& camera, ImageSize size,
                               Vec2 pixel, double radius);

}  // namespace rubble
