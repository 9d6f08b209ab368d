#pragma once

#include "core/io/JsonLayout.h"
#include "core/io/JsonReading.h"
#include "core/play/PlayInput.h"

namespace rubble {

/// Writes what came to a session, as an element of an array; reads it again. Types only: Session::add() looks at the values.
void writeTimedInput(JsonLayout& json, const TimedInput& timed);
TimedInput readTimedInput(const JsonValue& value);

}  // namespace rubble
