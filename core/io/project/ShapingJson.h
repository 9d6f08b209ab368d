#pragma once

#include "core/asset/project/Shaping.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"

namespace rubble {

/// Write and read the roughness of cuts as the member "roughness" of an object. Reading checks types only;
/// verifyShaping() checks the values.
void writeRoughness(JsonWriter& json, const Roughness& roughness);
Roughness readRoughness(const JsonValue& value);

/// Write and read the shaping of an asset's fragments as the member "shaping" of an object. Reading checks types only;
/// verifyShaping() checks the values.
void writeShaping(JsonWriter& json, const Shaping& shaping);
Shaping readShaping(const JsonValue& value);

/// Write and read a merge or a split of fragments as an element of an array. Reading checks types only; see
/// verifyEdit().
void writeEdit(JsonWriter& json, const FragmentEdit& edit);
FragmentEdit readEdit(const JsonValue& value);

}  // namespace rubble
