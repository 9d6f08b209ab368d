#pragma once

#include "core/fracture/sampling/GreyImage.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"

#include <memory>

namespace rubble {

/// Write and read a grey image: its size and one string per row with two hexadecimal digits per pixel, four at 16 bits.
/// Null for no image.
void writeGreyImage(JsonWriter& json, std::string_view key, const GreyImage* image);
std::shared_ptr<const GreyImage> readGreyImage(const JsonValue& value);

}  // namespace rubble
