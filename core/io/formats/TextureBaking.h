#pragma once

#include "core/asset/texture/AssetAtlas.h"
#include "core/io/exchange/MeshPart.h"
#include "core/io/exchange/PackBuilder.h"
#include "core/io/formats/PackOptions.h"

#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// The images of an asset's finishes, and where its meshes have them.
struct BakedTextures {
    TextureAtlas atlas;       // see assetAtlas()
    MeshMaterials materials;  // with the images

    Mesh wholeMesh(const Mesh& mesh) const { return atlas.textured(0, mesh); }
    Mesh fragmentMesh(std::uint32_t index, const Mesh& mesh) const { return atlas.textured(index + 1, mesh); }
};

/// The sides whose finishes are baked with some options: those that have a finish and are opaque. The outside of an
/// asset with an imported image keeps it.
TexturedSides bakedSides(const Asset& asset, const AssetMaterials& materials, const MeshOptions& options);

/// The names of the files with baked images: of colours, of normals, of roughness and metalness. They are written where
/// files refer to them: beside files of USD, and beside GLB files with one fragment each.
std::vector<std::string> bakedImageNames(const PackNames& names);
bool areImagesBeside(const MeshOptions& options);

/// The memory that baking takes, bytes.
double bakingBytes(const MeshOptions& options);

/// Bakes the finishes of an asset, as far as the options ask for it; nothing if no side is baked. `materials`: those of
/// files without baked images.
///
/// Errors: Limit if the fragments do not fit into images of that size; Cancelled.
Result<std::optional<BakedTextures>> bakedTextures(const PackInput& pack, const MeshOptions& options,
                                                   const FragmentMesher& mesher, const RoughCuts& cuts,
                                                   const MeshMaterials& materials, const TaskContext& task);

}  // namespace rubble
