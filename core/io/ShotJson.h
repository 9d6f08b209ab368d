#pragma once

#include "core/asset/Project.h"
#include "core/io/JsonLayout.h"
#include "core/io/JsonReading.h"

namespace rubble {

/// Write what is done to a scene and what is expected of it, each as an element of an array.
void writeShot(JsonLayout& json, const Shot& shot);
void writePlayTest(JsonLayout& json, const PlayTest& test);

/// Writes what a shot does as the members `name`, `kind` and `action` of an object; reads these of an object.
void writeShotAction(JsonLayout& json, const std::string& name, const ShotAction& action);
std::pair<std::string, ShotAction> readShotAction(const JsonValue& value);

/// Read what was written by these. Types only: verifyProject() looks at the values.
Shot readShot(const JsonValue& value);
PlayTest readPlayTest(const JsonValue& value);

/// Reads a list of shots as a project has them.
///
/// Errors: BadInput where the text is not such JSON, naming the place, or where a shot has numbers of no use.
Result<std::vector<Shot>> readShotList(std::string_view json);

}  // namespace rubble
