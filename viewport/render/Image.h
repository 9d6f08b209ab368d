#pragma once

#include "core/base/Result.h"
#include "core/base/image/PngEncoding.h"

#include <cstdint>
#include <string>
#include <vector>

namespace rubble {

/// Pixels in rows from top to bottom, three bytes (red, green, blue; sRGB) each.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;
    std::vector<std::uint8_t> opacities;  // one byte a pixel; none: all are opaque
};

/// What two images of equal size show in front of black and in front of white, with its opacities: glass and the edges
/// of things let some of the background through.
/// Source: Smith, Blinn, Blue screen matting, 1996.
Image cutOut(const Image& onBlack, const Image& onWhite);

/// Two opaque images of equal height side by side, with a white gap of `gap` pixels.
Image besideEachOther(const Image& left, const Image& right, int gap);

/// Encodes an image as PNG.
///
/// Errors: Limit if there is not enough memory.
Result<std::string> pngOf(const Image& image, PngEffort effort = PngEffort::Thorough);

}  // namespace rubble
