#pragma once

#include "core/fracture/pattern/Pattern.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"

namespace rubble {

/// Writes a polygon as the members "outline" and "holes" of an object.
void writeOutline(JsonWriter& json, const Polygon& outline);
/// Reads what writeOutline() wrote. Checks types only.
Polygon readOutline(const JsonValue& object);

/// Writes a pattern as the member "pattern" of an object: the array of its layers.
void writePattern(JsonWriter& json, const Pattern& pattern);

/// Reads what writePattern() wrote. Checks types only; verifyPattern() checks the values.
Pattern readPattern(const JsonValue& layers);

}  // namespace rubble
