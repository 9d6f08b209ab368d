#pragma once

#include "core/base/image/RadianceImage.h"
#include "core/geometry/predicates/Vec.h"

#include <optional>

namespace rubble {

// Directions in the picture of a sky: its centre is -z, and x is to the right of it.

/// The place of a direction of length 1, in [0, 1]²; y counts from the top.
Vec2 placeInSky(Vec3 direction);
/// Its inverse.
Vec3 directionInSky(Vec2 place);

/// The number of rows above the horizon, at least 1.
std::uint32_t rowsAboveHorizon(const RadianceImage& image);
/// The solid angle of each pixel of a row, sr.
double solidAngle(const RadianceImage& image, std::uint32_t row);
/// The relative luminance of a linear colour.
double luminance(const Vec3& colour);
/// The mean of all directions above the horizon.
Vec3 meanRadiance(const RadianceImage& image);

/// The radiance above the horizon, and below it that of the horizon, for computing light: pixels are the means of those
/// of a larger picture.
class SkySampler {
public:
    /// At most `maxWidth` pixels wide.
    SkySampler(const RadianceImage& image, std::uint32_t maxWidth);
    /// Interpolated between the pixels.
    Vec3 operator()(Vec3 direction) const;

private:
    const Vec3& pixel(std::int64_t x, std::int64_t y) const;

    std::int64_t m_width, m_rows;
    std::vector<Vec3> m_pixels;  // above the horizon
};

/// A lamp that is far away: the sun.
struct DirectionalLight {
    Vec3 direction;       // towards it, length 1
    Vec3 light;           // what a white surface that faces it reflects
    double radius = 0.0;  // of its distance
};

/// Takes the brightest region above the horizon out of a picture if it is small and gives a large part of the light:
/// the radiance around it remains.
/// Source: Debevec, "A median cut algorithm for light probe sampling", 2005, for lights in place of parts of a picture.
std::optional<DirectionalLight> takeKeyLight(RadianceImage& image);

}  // namespace rubble
