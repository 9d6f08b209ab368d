#pragma once

#include "core/fracture/GreyImage.h"
#include "core/io/JsonLayout.h"
#include "core/io/JsonReading.h"

#include <memory>

namespace rubble {

/// A picture as a project file holds it: its size, and a line a row, each pixel two hexadecimal digits, or four where it has 16
/// bits. Null for none.
void writeGreyImage(JsonLayout& json, std::string_view key, const GreyImage* image);
std::shared_ptr<const GreyImage> readGreyImage(const JsonValue& value);

}  // namespace rubble
