#pragma once

#include "core/geometry/Ray.h"
#include "core/geometry/TriangleMesh.h"
#include "core/geometry/Vec.h"

#include <glm/mat4x4.hpp>

#include <optional>

namespace rubble {

enum class Projection { Perspective, Orthographic };

/// From where a scene is seen: around a target, so that a level horizon stays level. All functions give a new camera.
struct Camera {
    Vec3 target{0.0, 0.0, 0.0};  // m, in the middle of the picture
    double azimuth = 0.0;        // rad; 0 looks along -z (front), a quarter turn along -x (right)
    double elevation = 0.0;      // rad; a quarter turn looks straight down
    double distance = 10.0;      // m, > 0, from eye to target
    double fieldOfView = 0.6;    // rad, of the picture's height
    Projection projection = Projection::Perspective;
    bool operator==(const Camera&) const = default;
};

/// The size of a picture.
struct PictureSize {
    int width = 1;   // pixels
    int height = 1;  // pixels
    double aspect() const { return static_cast<double>(width) / static_cast<double>(height); }
    bool operator==(const PictureSize&) const = default;
};

enum class StandardView { Front, Back, Right, Left, Top, Bottom, Isometric };
/// The camera turned to a view; target, distance and projection stay.
Camera turnedTo(Camera camera, StandardView view);

/// The camera's axes in the world: to the right, up, and backwards (from target to eye).
struct CameraAxes {
    Vec3 right, up, back;
};
CameraAxes axesOf(const Camera& camera);
Vec3 eyeOf(const Camera& camera);

/// What lies behind a point of the picture (pixels from its top left corner): from the eye, or where lines of sight are parallel from the
/// target's plane moved back by the camera's distance.
Ray rayThrough(const Camera& camera, Vec2 pixel, PictureSize size);
/// Where a point of the world is seen, pixels from the top left corner; nothing where it lies behind the eye.
std::optional<Vec2> pixelOf(const Camera& camera, Vec3 point, PictureSize size);

/// Metres that a pixel spans at the target.
double metresPerPixel(const Camera& camera, PictureSize size);

/// Turned about the target; the elevation stays within a quarter turn up and down.
Camera orbited(Camera camera, double azimuth, double elevation);
/// Moved so that what lies at the target follows the pointer, which went by these pixels (y downwards).
Camera panned(Camera camera, Vec2 pixels, PictureSize size);
/// Nearer (factor < 1) or farther, towards a point of the picture (pixels from its top left corner): what is seen there in
/// the target's plane stays there.
Camera dollied(Camera camera, double factor, Vec2 towards, PictureSize size);
/// With a box in the middle of the picture and as large as fits; turned as it is. An empty box changes nothing.
Camera framing(Camera camera, const Box3& box, PictureSize size);
/// A way between two cameras: `share` 0 gives `from`, 1 gives `to`. Turns the shorter way round.
Camera between(const Camera& from, const Camera& to, double share);

/// Matrices from the world less `origin` to the eye and on to clip space, whose depth just holds `bounds`.
struct CameraMatrices {
    glm::dmat4 view;
    glm::dmat4 projection;
};
CameraMatrices matricesOf(const Camera& camera, PictureSize size, Vec3 origin, const Box3& bounds);

}  // namespace rubble
