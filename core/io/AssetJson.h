#pragma once

#include "core/asset/Project.h"
#include "core/io/JsonLayout.h"
#include "core/io/JsonReading.h"

namespace rubble {

/// A colour is an array of red, green and blue.
void writeColour(JsonLayout& json, std::string_view key, const Colour& colour);
Colour readColour(const JsonValue& value);

/// Writes a material or an asset as an element of an array.
void writeMaterial(JsonLayout& json, const Material& material);
void writeAsset(JsonLayout& json, const Asset& asset);

/// A material without what came after the first version, as recordings of play hold it.
void writeMaterialVersion1(JsonLayout& json, const Material& material);

/// Read what was written by these. Types only: verifyProject() looks at the values.
Material readMaterial(const JsonValue& value);
Asset readAsset(const JsonValue& value);
/// The same of a project of version 1, which knew neither cuts at impact nor intents, of versions 2 and 3, which knew nothing
/// that is done to pieces, and of version 4, which knew nothing of strength. Materials are the same from 1 to 4.
Material readMaterialVersion1(const JsonValue& value);
Asset readAssetVersion1(const JsonValue& value);
Asset readAssetVersion2(const JsonValue& value);
Asset readAssetVersion4(const JsonValue& value);

}  // namespace rubble
