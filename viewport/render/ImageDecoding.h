#pragma once

#include "core/base/image/EncodedImage.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace rubble {

/// The pixels of a picture, rows from the top, three bytes each: red, green, blue in sRGB.
struct DecodedImage {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> pixels;
};

/// Decodes an image without its opacity, in 1, 1/2, 1/4 … of its size so that no side is longer than `longest` or
/// 4096 pixels; takes little more memory than the result. Nothing if it is damaged, or has colours other than grey, RGB
/// and YCbCr.
std::optional<DecodedImage> decoded(const EncodedImage& image, std::uint32_t longest);

}  // namespace rubble
