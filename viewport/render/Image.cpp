#include "viewport/render/Image.h"

#include "core/base/Assert.h"

#include <png.h>

namespace rubble {

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

Result<std::string> pngOf(const Image& image) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr) == 0) {
        return Error{ErrorCode::Limit, std::string("The image could not be encoded as PNG: ") + png.message + "."};
    }
    bytes.resize(size);
    return bytes;
}

}  // namespace rubble
