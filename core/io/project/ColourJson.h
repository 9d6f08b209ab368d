#pragma once

#include "core/asset/project/Project.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"

namespace rubble {

/// A colour as an array of three numbers: red, green and blue.
void writeColour(JsonWriter& json, std::string_view key, const Colour& colour);
Colour readColour(const JsonValue& value);

/// The opacity of a material; 1 is not written.
void writeOpacity(JsonWriter& json, double opacity);
/// Reads the optional key "opacity" of a material.
double readOpacity(const JsonValue& material);

/// The finish of a material; a plain one is not written.
void writeFinish(JsonWriter& json, Finish finish);
/// Reads the optional key "finish" of a material.
Finish readFinish(const JsonValue& material);

}  // namespace rubble
