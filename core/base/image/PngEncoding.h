#pragma once

#include "core/base/Result.h"

#include <cstdint>
#include <span>
#include <string>

namespace rubble {

/// How a PNG file is compressed: as well as possible, or in a fifth of the time, a fifth larger.
enum class PngEffort { Thorough, Quick };

/// Pixels in rows from top to bottom: red, green and blue, a byte each. Borrowed.
struct PngPixels {
    int width = 0;
    int height = 0;
    std::span<const std::uint8_t> colours;
    std::span<const std::uint8_t> opacities = {};  // one byte a pixel; none: all are opaque
};

/// Encodes pixels as a PNG file.
///
/// Errors: Limit if there is not enough memory.
Result<std::string> encodedPng(const PngPixels& pixels, PngEffort effort = PngEffort::Thorough);

}  // namespace rubble
