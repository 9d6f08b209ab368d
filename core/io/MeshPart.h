#pragma once

#include "core/asset/Project.h"
#include "core/geometry/Mesh.h"

#include <string>
#include <vector>

namespace rubble {

/// One body of a mesh file: its surface in its own frame, and where that frame stands in the asset's.
struct MeshPart {
    std::string name;  // one word, see meshName()
    Mesh mesh;
    Vec3 offset{0.0, 0.0, 0.0};  // m
};

/// Where the bodies of a mesh file lie.
enum class PartPlace {
    Assembled,  // at their offsets: together they are the asset
    Centred,    // each about its own origin, its centre of mass
};

/// A material as mesh files tell it.
struct MeshMaterial {
    std::string name;  // one word
    Colour colour;
};

/// The materials of one asset. All names differ.
struct MeshMaterials {
    std::vector<MeshMaterial> outside;  // by MeshFace::material; at least one
    MeshMaterial inside;
};

/// `name` as one word that is good for the name of a file, of an object and of a material in every mesh format: spaces,
/// control characters and those with a meaning there become '_'. Never empty.
std::string meshName(const std::string& name);

/// The materials of an asset made of `material`: outside those of the mesh it was imported from, by their own names, or
/// else "<material>_outside"; inside "<material>_inside". A name that is taken gets the next free number.
MeshMaterials meshMaterials(const Asset& asset, const AssetMaterials& material);

}  // namespace rubble
