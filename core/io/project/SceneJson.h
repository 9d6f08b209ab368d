#pragma once

#include "core/asset/project/Project.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"

namespace rubble {

/// Write an instance as an element of an array; ground, damage, debris and settings of events as members of an object.
void writeInstance(JsonWriter& json, const Instance& instance);
void writeGround(JsonWriter& json, const Ground& ground);
/// The members of a ground that is on.
void writeGroundPlane(JsonWriter& json, const Ground& ground);
void writeDamage(JsonWriter& json, const Damage& damage);
void writeDebris(JsonWriter& json, const Debris& debris);
void writeEventSettings(JsonWriter& json, const EventSettings& events);

/// Read what the functions above wrote. They check types only; verifyProject() checks the values.
Instance readInstance(const JsonValue& value);
/// Reads an instance of versions 1 and 2, which has no variant and is neither hidden nor locked.
Instance readInstanceBeforeVersion3(const JsonValue& value);
Ground readGround(const JsonValue& value);
Damage readDamage(const JsonValue& value);
Debris readDebris(const JsonValue& value);
EventSettings readEventSettings(const JsonValue& value);

}  // namespace rubble
