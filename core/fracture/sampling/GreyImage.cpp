#include "core/fracture/sampling/GreyImage.h"

#include <algorithm>

namespace rubble {
namespace {

/// Maps a side of an image to a shorter one. Lengths are in units in which a pixel of the long side is `to` long, and
/// one of the short side `from`.
struct SideReduction {
    std::uint64_t from = 1;  // pixels
    std::uint64_t to = 1;    // pixels

    std::uint64_t first(std::uint64_t pixel) const { return pixel * from / to; }
    std::uint64_t end(std::uint64_t pixel) const { return ((pixel + 1) * from + to - 1) / to; }
    /// The length that a pixel of the short side has in common with one of the long side.
    std::uint64_t overlap(std::uint64_t pixel, std::uint64_t source) const {
        return std::min((pixel + 1) * from, (source + 1) * to) - std::max(pixel * from, source * to);
    }
};

std::uint16_t roundedQuotient(std::uint64_t sum, std::uint64_t weight) {
    return static_cast<std::uint16_t>(weight == 0 ? 0 : (sum + weight / 2) / weight);
}

}  // namespace

GreyImage reduced(GreyImage image, std::uint32_t maxSide) {
    const std::uint32_t longer = std::max(image.width, image.height);
    if (longer <= maxSide) return image;
    const auto reducedSide = [&](std::uint32_t side) {
        return std::max(1u, static_cast<std::uint32_t>(std::uint64_t{side} * maxSide / longer));
    };
    GreyImage result{.width = reducedSide(image.width), .height = reducedSide(image.height), .bits = image.bits};
    const SideReduction across{image.width, result.width}, down{image.height, result.height};
    for (std::uint64_t y = 0; y < result.height; ++y) {
        for (std::uint64_t x = 0; x < result.width; ++x) {
            std::uint64_t grey = 0, opacity = 0, area = 0;
            for (std::uint64_t row = down.first(y); row < down.end(y); ++row) {
                for (std::uint64_t column = across.first(x); column < across.end(x); ++column) {
                    const std::uint64_t pixel = row * image.width + column;
                    const std::uint64_t part = across.overlap(x, column) * down.overlap(y, row);
                    const std::uint64_t opaque = part * (image.opacity.empty() ? 1u : image.opacity[pixel]);
                    grey += opaque * image.grey[pixel];
                    opacity += opaque;
                    area += part;
                }
            }
            result.grey.push_back(roundedQuotient(grey, opacity));
            if (!image.opacity.empty()) result.opacity.push_back(roundedQuotient(opacity, area));
        }
    }
    return result;
}

std::optional<std::string> verifyGreyImage(const GreyImage& image) {
    const auto size = std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels";
    if (image.width == 0 || image.height == 0 || std::max(image.width, image.height) > GreyImage::kMaxSide) {
        return "the image has " + size + ", but from 1 to " + std::to_string(GreyImage::kMaxSide) +
               " a side are allowed";
    }
    if (image.bits != 8 && image.bits != 16) {
        return "the image has " + std::to_string(image.bits) + " bits per pixel, but must have 8 or 16";
    }
    const std::size_t pixels = std::size_t{image.width} * image.height;
    for (const auto* values : {&image.grey, &image.opacity}) {
        if (values == &image.opacity && values->empty()) continue;
        if (values->size() != pixels) {
            return "the image has " + std::to_string(values->size()) + " values for " + size;
        }
        const auto tooGreat = std::ranges::find_if(*values, [&](std::uint32_t value) { return value > image.white(); });
        if (tooGreat != values->end()) {
            return "the image has a value of " + std::to_string(*tooGreat) + ", but " + std::to_string(image.white()) +
                   " is white";
        }
    }
    return std::nullopt;
}

}  // namespace rubble
