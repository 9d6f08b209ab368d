#pragma once

#include "core/geometry/mesh/Mesh.h"
#include "core/io/exchange/MeshPart.h"
#include "core/io/exchange/UsdWriter.h"

namespace rubble {

/// Writes a material that is drawn, textured with image files beside the layer if it is textured or baked; returns its
/// path. `baked`: null if it is not baked.
std::string writeUsdMaterial(UsdWriter& usd, UsdNames& names, const MeshMaterial& material,
                             const std::string& imageFile, const BakedImages* baked = nullptr);

/// Writes the extent, the faces (`counts`: corners of each) and the points of a Mesh that was begun. Not empty.
void writeUsdFaces(UsdWriter& usd, std::span<const std::uint32_t> counts, std::span<const std::uint32_t> indices,
                   std::span<const Vec3> points);

/// Writes a Mesh with normals, texture coordinates and materials. `surfaces`: paths of materials, by
/// MeshFace::material, that of the inside last.
void writeUsdMesh(UsdWriter& usd, std::string_view name, const Mesh& mesh, std::span<const std::string> surfaces);

}  // namespace rubble
