#pragma once

#include "core/base/Result.h"

#include <cstdint>
#include <string>
#include <vector>

namespace rubble {

/// Pixels in rows from top to bottom, three bytes (red, green, blue; sRGB) each.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;
};

/// Two images of equal height side by side, with a white gap of `gap` pixels.
Image besideEachOther(const Image& left, const Image& right, int gap);

/// How a PNG file is compressed: as well as possible, or in a fifth of the time, a fifth larger.
enum class PngEffort { Thorough, Quick };

/// Encodes an image as PNG.
///
/// Errors: Limit if there is not enough memory.
Result<std::string> pngOf(const Image& image, PngEffort effort = PngEffort::Thorough);

}  // namespace rubble
