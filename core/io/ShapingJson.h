#pragma once

#include "core/asset/Shaping.h"
#include "core/io/JsonLayout.h"
#include "core/io/JsonReading.h"

namespace rubble {

/// What is done to an asset's pieces, as the member "shaping" of an object, and back. Types only: verifyShaping() looks at the
/// values.
void writeShaping(JsonLayout& json, const Shaping& shaping);
Shaping readShaping(const JsonValue& value);

/// A merge or a split of fragments as an element of an array, and back. Types only, see verifyEdit().
void writeEdit(JsonLayout& json, const FragmentEdit& edit);
FragmentEdit readEdit(const JsonValue& value);

}  // namespace rubble
