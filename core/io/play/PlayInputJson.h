#pragma once

#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"
#include "core/play/scene/PlayInput.h"

namespace rubble {

/// Write and read an input of a session as an element of an array. Reading checks types only; Session::add() checks the
/// values.
void writeTimedInput(JsonWriter& json, const TimedInput& timed);
TimedInput readTimedInput(const JsonValue& value);

}  // namespace rubble
