#pragma once

#include "core/base/Result.h"

#include <cstdint>
#include <string>
#include <vector>

namespace rubble {

/// A picture: rows from top to bottom, three bytes (red, green, blue; sRGB) a pixel.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;
};

/// Two pictures of one height, with so many white pixels between them.
Image besideEachOther(const Image& left, const Image& right, int gap);

/// The picture as a PNG file's bytes.
///
/// Errors: Limit where there is no memory for it.
Result<std::string> pngOf(const Image& image);

}  // namespace rubble
