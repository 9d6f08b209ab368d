#pragma once

#include "core/asset/project/Project.h"
#include "core/geometry/mesh/Mesh.h"

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// A body of a mesh file: its surface in its own frame, and the offset of that frame in the asset's.
struct MeshPart {
    std::string name;  // without spaces, see meshName()
    Mesh mesh;
    Vec3 offset{0.0, 0.0, 0.0};  // m
};

/// The positions of the bodies in a mesh file.
enum class PartPlacement {
    Assembled,  // at their offsets: together they form the asset
    Centred,    // each with its centre of mass at the origin
};

/// A material of a mesh file.
struct MeshMaterial {
    std::string name;  // without spaces
    Colour colour;
    double opacity = 1.0;
    bool isTextured = false;  // its colour is multiplied by the image
    bool isBaked = false;     // its colour, normals, roughness and metalness are those of baked images
    double roughness() const { return opacity < 1.0 ? 0.1 : 0.9; }
    bool operator==(const MeshMaterial&) const = default;
};

/// An image and the name of its file.
struct MeshImage {
    std::string name;
    std::shared_ptr<const EncodedImage> image;
};

/// The images of baked materials, see BakedMaps.
struct BakedImages {
    MeshImage colour, normal, surface;
    bool areBeside = false;  // GLB files refer to them instead of containing them
};

/// The materials of an asset, with unique names.
struct MeshMaterials {
    std::vector<MeshMaterial> outside;  // by MeshFace::material; at least one
    MeshMaterial inside;
    std::shared_ptr<const EncodedImage> image;  // null: no material is textured
    std::string imageFile;                      // a name without spaces, with the suffix of its type
    std::optional<BakedImages> baked;           // none: no material is baked
};

/// A colour in linear light, as glTF and USD have it.
Vec3 linearColour(const Colour& colour);

/// Returns `name` as a valid name of files, objects and materials in every mesh format: spaces, control characters and
/// characters with a special meaning become '_'. Never empty.
std::string meshName(const std::string& name);

/// Returns the name of the file with a texture's image, for its name in the project.
std::string imageFileName(const Texture& texture);

/// Returns `name`, with a number from 2 on if it is in `taken` already, and adds the result to `taken`.
std::string uniqueName(const std::string& name, std::set<std::string>& taken);

/// What the importer of Godot does with a material because its name ends so, as the end of a sentence: "makes it
/// transparent"; nothing for other names.
/// Source: Godot Engine, "Node type customization using name suffixes".
std::optional<std::string> importerEffect(std::string_view materialName);

/// Returns the materials of an asset: outside those of the mesh it was imported from, or "<material>_outside" if there
/// is none; inside "<material>_inside". A number makes a name unique. The texture's image is called as its file was.
MeshMaterials meshMaterials(const Asset& asset, const AssetMaterials& material);

}  // namespace rubble
