#include "core/fracture/sampling/GreyImage.h"

#include <algorithm>

namespace rubble {

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
