#pragma once

#include "viewport/render/Image.h"
#include "viewport/render/RenderSettings.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace rubble {

/// A picture on a page, with the number that stands in its upper left corner.
struct NumberedPicture {
    std::uint32_t number = 0;
    std::optional<Image> picture;  // none: an empty place
};

/// Pictures of one size in rows, about as many as columns, numbered in digits of plain pixels.
Image sheetPage(const std::vector<NumberedPicture>& pictures, Theme theme);

}  // namespace rubble
