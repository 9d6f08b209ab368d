#pragma once

#include "core/fracture/Pattern.h"
#include "core/io/JsonLayout.h"
#include "core/io/JsonReading.h"

namespace rubble {

/// Writes a pattern as a member of an object: the array of its layers.
void writePattern(JsonLayout& json, const Pattern& pattern);

/// Reads what writePattern() wrote. Types only: verifyPattern() looks at the values.
Pattern readPattern(const JsonValue& layers);

}  // namespace rubble
