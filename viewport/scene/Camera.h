#pragma once

#include "core/geometry/hull/Ray.h"
#include "core/geometry/mesh/TriangleMesh.h"
#include "core/geometry/predicates/Vec.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <optional>

namespace rubble {

enum class Projection { Perspective, Orthographic };

/// An orbit camera around a target, without roll, so that the horizon stays level. All functions return a new camera.
struct Camera {
    Vec3 target{0.0, 0.0, 0.0};  // m, at the centre of the image
    double azimuth = 0.0;        // rad; 0 looks along -z (front), pi/2 along -x (right)
    double elevation = 0.0;      // rad; pi/2 looks straight down
    double distance = 10.0;      // m, > 0, from eye to target
    double fieldOfView = 0.6;    // rad, vertical
    Projection projection = Projection::Perspective;
    bool operator==(const Camera&) const = default;
};

/// The size of an image.
struct ImageSize {
    int width = 1;   // pixels
    int height = 1;  // pixels
    double aspect() const { return static_cast<double>(width) / static_cast<double>(height); }
    bool operator==(const ImageSize&) const = default;
};

enum class StandardView { Front, Back, Right, Left, Top, Bottom, Isometric };
/// The camera rotated to a standard view; target, distance and projection stay.
Camera alignedTo(Camera camera, StandardView view);

/// The camera's axes in the world: right, up, and back (from the target to the eye).
struct CameraAxes {
    Vec3 right, up, back;
};
CameraAxes axesOf(const Camera& camera);
Vec3 eyeOf(const Camera& camera);

/// The ray through a point of the image (pixels from its top left corner). It starts at the eye in perspective, and in
/// the plane through the eye in parallel projection.
Ray rayThrough(const Camera& camera, Vec2 pixel, ImageSize size);
/// Projects a point of the world, pixels from the top left corner; nothing if it lies behind the eye, or within a
/// millionth of the camera's distance before it.
std::optional<Vec2> pixelOf(const Camera& camera, Vec3 point, ImageSize size);
/// Projects the part of a segment that is before the eye and in the image, or within the image's size beside it;
/// nothing if there is none. Its ends may be anywhere, so draw lines with this.
std::optional<std::array<Vec2, 2>> pixelsOf(const Camera& camera, Vec3 from, Vec3 to, ImageSize size);

/// The size of a pixel at the target's distance, m.
double metresPerPixel(const Camera& camera, ImageSize size);

/// Orbits about the target by two angles; the elevation is clamped to ±90°.
Camera orbited(Camera camera, double azimuth, double elevation);
/// Pans by pixels (y downwards), so that the target's plane follows the pointer.
Camera panned(Camera camera, Vec2 pixels, ImageSize size);
/// Scales the distance by `factor` and keeps the point of the target's plane under `anchor` (pixels from the top left
/// corner) there.
Camera dollied(Camera camera, double factor, Vec2 anchor, ImageSize size);
/// Strips at the edges of an image that are covered, pixels.
struct ImageStrips {
    double top = 0.0;
    double bottom = 0.0;
    bool operator==(const ImageStrips&) const = default;
};
/// Moves the camera so that a box fills the image between the strips; its orientation stays. An empty box changes
/// nothing. Strips may take up to three quarters of the image; more is ignored.
Camera framing(Camera camera, const Box3& box, ImageSize size, const ImageStrips& strips = {});
/// Interpolates two cameras: `fraction` 0 gives `from`, 1 gives `to`. Rotates the shorter way.
Camera interpolated(const Camera& from, const Camera& to, double fraction);

/// The view matrix, from the world minus `origin`, and the projection matrix, whose depth range just contains `bounds`.
struct CameraMatrices {
    glm::dmat4 view;
    glm::dmat4 projection;
};
CameraMatrices matricesOf(const Camera& camera, ImageSize size, Vec3 origin, const Box3& bounds);

}  // namespace rubble
