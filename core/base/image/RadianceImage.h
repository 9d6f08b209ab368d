#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rubble {

/// The radiance in all directions as an equirectangular picture: rows from the zenith to the nadir, columns to the
/// right around the vertical axis.
struct RadianceImage {
    /// A larger picture is reduced when it is read: a pixel is still smaller than the sun.
    static constexpr std::uint32_t kMaxWidth = 2048;

    std::uint32_t width = 0;  // twice the height
    std::uint32_t height = 0;
    std::vector<std::array<float, 3>> pixels;  // red, green and blue, linear; row by row
    bool operator==(const RadianceImage&) const = default;
};

}  // namespace rubble
