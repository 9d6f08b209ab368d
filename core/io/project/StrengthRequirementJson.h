#pragma once

#include "core/asset/project/Project.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"

namespace rubble {

/// Writes the cut at impact of an asset as the member "cutAtImpact", null without one.
void writeCutAtImpact(JsonWriter& json, const std::optional<CutAtImpact>& cut);
/// Writes a strength requirement as an element of an array, on one line.
void writeRequirement(JsonWriter& json, const StrengthRequirement& requirement);
/// Writes the members of a strength requirement into an open object.
void writeRequirementMembers(JsonWriter& json, const StrengthRequirement& requirement);

/// Read what the functions above wrote. They check types only; verifyProject() checks the values.
CutAtImpact readCutAtImpact(const JsonValue& value);
StrengthRequirement readRequirement(const JsonValue& value);

}  // namespace rubble
