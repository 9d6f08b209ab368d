#pragma once

#include "core/asset/Project.h"
#include "core/io/JsonLayout.h"
#include "core/io/JsonReading.h"

namespace rubble {

/// Writes a material or an asset as an element of an array.
void writeMaterial(JsonLayout& json, const Material& material);
void writeAsset(JsonLayout& json, const Asset& asset);

/// Read what was written by these. Types only: verifyProject() looks at the values.
Material readMaterial(const JsonValue& value);
Asset readAsset(const JsonValue& value);
/// The same of a project of version 1, which knew neither cuts at impact nor intents, and of versions 2 and 3, which knew nothing
/// that is done to pieces.
Asset readAssetVersion1(const JsonValue& value);
Asset readAssetVersion2(const JsonValue& value);

}  // namespace rubble
