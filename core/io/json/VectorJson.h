#pragma once

#include "core/asset/project/Project.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"

namespace rubble {

/// Vectors and colours as arrays of three numbers.
void writeVector(JsonWriter& json, std::string_view key, Vec3 vector);
Vec3 readVector(const JsonValue& value);
void writeColour(JsonWriter& json, std::string_view key, const Colour& colour);
Colour readColour(const JsonValue& value);

}  // namespace rubble
