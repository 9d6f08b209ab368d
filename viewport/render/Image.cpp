#include "viewport/render/Image.h"

#include "core/base/Assert.h"

#include <algorithm>

namespace rubble {

Image cutOut(const Image& onBlack, const Image& onWhite) {
    RUBBLE_ASSERT(onBlack.width == onWhite.width && onBlack.height == onWhite.height);
    Image image = onBlack;
    image.opacities.resize(image.pixels.size() / 3);
    for (std::size_t k = 0; k < image.opacities.size(); ++k) {
        int shining = 0;  // of the white background, summed over the colours
        for (std::size_t c = 3 * k; c < 3 * k + 3; ++c) shining += onWhite.pixels[c] - onBlack.pixels[c];
        const int opacity = std::clamp(255 - (shining + 1) / 3, 0, 255);
        image.opacities[k] = static_cast<std::uint8_t>(opacity);
        for (std::size_t c = 3 * k; c < 3 * k + 3 && opacity > 0; ++c)
            image.pixels[c] =
                static_cast<std::uint8_t>(std::min(255, (255 * onBlack.pixels[c] + opacity / 2) / opacity));
    }
    return image;
}

Image besideEachOther(const Image& left, const Image& right, int gap) {
    RUBBLE_ASSERT(left.height == right.height);
    Image both{left.width + gap + right.width, left.height, {}};
    both.pixels.reserve(3 * static_cast<std::size_t>(both.width) * static_cast<std::size_t>(both.height));
    const auto addRow = [&](const Image& image, int row) {
        const std::ptrdiff_t bytes = 3 * static_cast<std::ptrdiff_t>(image.width);
        const auto first = image.pixels.begin() + row * bytes;
        both.pixels.insert(both.pixels.end(), first, first + bytes);
    };
    for (int row = 0; row < both.height; ++row) {
        addRow(left, row);
        both.pixels.insert(both.pixels.end(), 3 * static_cast<std::size_t>(gap), 255);
        addRow(right, row);
    }
    return both;
}

Result<std::string> pngOf(const Image& image, PngEffort effort) {
    return encodedPng({image.width, image.height, image.pixels, image.opacities}, effort);
}

}  // namespace rubble
