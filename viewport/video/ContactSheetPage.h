#pragma once

#include "viewport/render/Image.h"
#include "viewport/render/RenderSettings.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace rubble {

/// An image on a page, with the number that is drawn in its upper left corner.
struct NumberedImage {
    std::uint32_t number = 0;
    std::optional<Image> image;  // none: an empty cell
};

/// Arranges images of one size in a square grid, numbered with a bitmap font.
Image contactSheetPage(const std::vector<NumberedImage>& images, Theme theme);

}  // namespace rubble
