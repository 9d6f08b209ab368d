#pragma once

#include "core/geometry/predicates/Vec.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"

namespace rubble {

/// A vector as an array of three numbers.
void writeVector(JsonWriter& json, std::string_view key, Vec3 vector);
Vec3 readVector(const JsonValue& value);

}  // namespace rubble
