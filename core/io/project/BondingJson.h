#pragma once

#include "core/asset/project/Project.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"

namespace rubble {

/// Writes how an asset breaks as the members "breakAs" and "bonding", each only where it differs from its default.
void writeBonding(JsonWriter& json, const Asset& asset);
/// Writes a mortar as an element of an array.
void writeMortar(JsonWriter& json, const Mortar& mortar);

/// Read what the functions above wrote; "breakAs" and "bonding" are optional keys of `value`. They check types only;
/// verifyProject() checks the values.
void readBonding(const JsonValue& value, Asset& asset);
Mortar readMortar(const JsonValue& value);

/// The optional key "bondStrength" of a level or an instance; 1 is not written.
void writeBondStrength(JsonWriter& json, double strength);
double readBondStrength(const JsonValue& value);

}  // namespace rubble
