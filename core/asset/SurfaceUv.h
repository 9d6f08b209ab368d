#pragma once

#include "core/asset/Surface.h"

namespace rubble {

/// A cap's map at a point of the xy plane.
Vec2 mapped(const AffineUv& map, Vec2 point);

/// The look of a source mesh at one place.
struct SurfaceLook {
    Vec2 uv{0.0, 0.0};
    std::uint32_t material = 0;  // index into Surface::materials
};

/// The look at `point`, on a face with the given normal and with `faceCentre` as centre. Taken from the nearest source
/// triangle that faces the same way, at its own nearest point: never extrapolated. Where several triangles meet
/// at the point, the one towards the centre is meant. Linear in the triangles.
SurfaceLook surfaceLook(const Surface& surface, Vec3 point, Vec3 faceCentre, Vec3 normal);

}  // namespace rubble
