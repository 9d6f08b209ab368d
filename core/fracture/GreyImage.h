#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// A grey picture with 8 or 16 bits a pixel, and as many of opacity where it has any. Rows go from the top to the bottom.
struct GreyImage {
    static constexpr std::uint32_t kMostSide = 1024;  // pixels

    std::uint32_t width = 0;  // from 1 to kMostSide
    std::uint32_t height = 0;
    std::uint32_t bits = 8;              // 8 or 16
    std::vector<std::uint16_t> grey;     // one a pixel, below 2^bits; 0 is black
    std::vector<std::uint16_t> opacity;  // the same; 0 lets all through. Empty: opaque

    std::uint32_t white() const { return (1u << bits) - 1u; }
    bool operator==(const GreyImage&) const = default;
};

/// Says what is wrong with a picture, as the end of a sentence that names its layer, or nothing where all is well.
std::optional<std::string> verifyGreyImage(const GreyImage& image);

}  // namespace rubble
