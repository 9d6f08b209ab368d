#pragma once

#include "core/io/exchange/MeshPart.h"
#include "core/io/exchange/PackBody.h"
#include "core/io/json/JsonWriter.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// A rigid body of a GLB file.
struct GlbBody {
    PackBody body;
    std::string parent;  // the id of the body that it is a fragment of; empty: it is the whole
};

/// How the rigid bodies of a GLB file are described.
enum class GlbBodyForm {
    Extensions,  // KHR_physics_rigid_bodies and OMI_physics_body
    Names,       // the hulls alone, as meshes "UCX_<body>_<k>", which Unreal Engine takes for collision
};

/// The rigid bodies of a GLB file.
struct GlbPhysics {
    std::vector<GlbBody> bodies;  // one for each part
    Material material;            // of all bodies
    GlbBodyForm form = GlbBodyForm::Extensions;
};

/// Writes the members "extensionsUsed" and "extensions" of the file. `firstMesh` is the index of the first hull's mesh;
/// the meshes of hulls are consecutive.
void writePhysicsExtensions(JsonWriter& json, const GlbPhysics& physics, std::uint64_t firstMesh);

/// Writes "scene", "scenes" and "nodes". By extensions, the node of a body has a child with its mesh, and a child for
/// each hull; each hull has another node outside the scene, to which its collider refers. By names, parts and hulls are
/// nodes side by side.
void writePhysicsNodes(JsonWriter& json, std::span<const MeshPart> parts, PartPlacement place,
                       const GlbPhysics& physics);

/// Writes the meshes of hulls as elements of "meshes". The accessors of each, positions and indices, are consecutive
/// from `firstAccessor` on.
void writeHullMeshes(JsonWriter& json, std::span<const MeshPart> parts, const GlbPhysics& physics,
                     std::uint64_t firstAccessor);

}  // namespace rubble
