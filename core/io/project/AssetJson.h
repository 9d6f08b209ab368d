#pragma once

#include "core/asset/project/Project.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/project/MeshFolder.h"
#include "core/io/project/TextureJson.h"

namespace rubble {

/// Write a material and an asset as elements of an array. `images`: imagesOf() the project.
void writeMaterial(JsonWriter& json, const Material& material);
void writeAsset(JsonWriter& json, const Asset& asset, const ImageList& images);

/// Writes a material in version 1, which replay files use.
void writeMaterialBeforeVersion5(JsonWriter& json, const Material& material);

/// Read what the functions above wrote, an asset without its texture and, if it has one, its mesh. They check types
/// only; verifyProject() checks the values.
Material readMaterial(const JsonValue& value);
Asset readAsset(const JsonValue& value);
/// Gives the assets of a project, that readAsset() read without errors, their meshes.
///
/// Errors, with the asset: Unsupported if there are no `meshes`; those of `meshes`; BadInput for a mesh of another
/// size than the project says.
Status readMeshes(JsonDocument& document, std::vector<Asset>& assets, const MeshSource& meshes);
/// Read materials of the versions 1 to 4, and assets of version 1 (no cuts at impact, no strength requirements),
/// versions 2 and 3 (no shaping of fragments), version 4 (no material strength) and version 5 (no meshes).
Material readMaterialBeforeVersion5(const JsonValue& value);
Asset readAssetVersion1(const JsonValue& value);
Asset readAssetVersions2To3(const JsonValue& value);
Asset readAssetVersion4(const JsonValue& value);
Asset readAssetVersion5(const JsonValue& value);

}  // namespace rubble
