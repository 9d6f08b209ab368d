#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// A grey-scale image with 8 or 16 bits per pixel, and as many of opacity if it has an alpha channel. Rows from top to
/// bottom.
struct GreyImage {
    static constexpr std::uint32_t kMaxSide = 1024;  // pixels

    std::uint32_t width = 0;  // from 1 to kMaxSide
    std::uint32_t height = 0;
    std::uint32_t bits = 8;              // 8 or 16
    std::vector<std::uint16_t> grey;     // one per pixel, below 2^bits; 0: black
    std::vector<std::uint16_t> opacity;  // the same; 0: transparent. Empty: opaque

    std::uint32_t white() const { return (1u << bits) - 1u; }
    bool operator==(const GreyImage&) const = default;
};

/// Which pixels of an image mean a high density.
enum class DenseWhere { Bright, Dark };

/// The grey of a colour, the weighted mean of its channels; exact for grey colours.
constexpr std::uint32_t luminanceOf(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
    return (11u * red + 16u * green + 5u * blue) / 32u;
}

/// An image of up to 2^26 pixels at a size of at most `maxSide` pixels a side, in about the same proportions; the image
/// itself if it is no larger. Each pixel has the mean opacity of the area that it covers, and the mean grey weighted by
/// opacity, so that the mean density stays.
GreyImage reduced(GreyImage image, std::uint32_t maxSide = GreyImage::kMaxSide);

/// The fault of an image, as the end of a sentence that names its layer; nothing if it is valid.
std::optional<std::string> verifyGreyImage(const GreyImage& image);

}  // namespace rubble
