#pragma once

#include "core/asset/Project.h"
#include "core/io/JsonLayout.h"
#include "core/io/JsonReading.h"

namespace rubble {

/// Write what stands in a scene: instances as elements of an array, ground, damage and debris as members of an
/// object.
void writeInstance(JsonLayout& json, const Instance& instance);
void writeGround(JsonLayout& json, const Ground& ground);
void writeDamage(JsonLayout& json, const Damage& damage);
void writeDebris(JsonLayout& json, const Debris& debris);

/// Read what was written by these. Types only: verifyProject() looks at the values.
Instance readInstance(const JsonValue& value);
/// An instance of before there were variants, and before any could be hidden or locked.
Instance readInstanceVersion2(const JsonValue& value);
Ground readGround(const JsonValue& value);
Damage readDamage(const JsonValue& value);
Debris readDebris(const JsonValue& value);

/// A vector as an array of three numbers.
void writeVector(JsonLayout& json, std::string_view key, Vec3 vector);
Vec3 readVector(const JsonValue& value);

}  // namespace rubble
