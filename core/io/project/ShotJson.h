#pragma once

#include "core/asset/project/Project.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"

namespace rubble {

/// The name of a kind in files: "ball".
std::string_view nameOf(ProjectileKind kind);

/// Write a shot and a play-test as elements of an array.
void writeShot(JsonWriter& json, const Shot& shot);
void writePlayTest(JsonWriter& json, const PlayTest& test);

/// Write and read the action of a shot as the members `name`, `kind` and `action` of an object.
void writeShotAction(JsonWriter& json, const std::string& name, const ShotAction& action);
std::pair<std::string, ShotAction> readShotAction(const JsonValue& value);

/// Write and read paths of fragments as the member `fragments`; none where it is missing.
void writeFragmentPaths(JsonWriter& json, const std::vector<FragmentPath>& paths);
std::vector<FragmentPath> readFragmentPaths(const JsonValue& value);

/// Read what the functions above wrote. They check types only; verifyProject() checks the values.
Shot readShot(const JsonValue& value);
PlayTest readPlayTest(const JsonValue& value);

/// Reads an array of shots as in a project file.
///
/// Errors: BadInput if the text is not JSON of this form, with the path, or if a shot has invalid values.
Result<std::vector<Shot>> readShotList(std::string_view json);

}  // namespace rubble
