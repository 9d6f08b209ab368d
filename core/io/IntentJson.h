#pragma once

#include "core/asset/Project.h"
#include "core/io/JsonLayout.h"
#include "core/io/JsonReading.h"

namespace rubble {

/// Write how an asset takes hits: its cut at impact as the member "cutAtImpact", null where there is none; an intent as
/// an element of an array, on one line.
void writeCutAtImpact(JsonLayout& json, const std::optional<CutAtImpact>& cut);
void writeIntent(JsonLayout& json, const Intent& intent);
/// What stands in it, for an object that has more to say.
void writeIntentMembers(JsonLayout& json, const Intent& intent);

/// Read what was written by these. Types only: verifyProject() looks at the values.
CutAtImpact readCutAtImpact(const JsonValue& value);
Intent readIntent(const JsonValue& value);

}  // namespace rubble
