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

/// The rigid bodies of a GLB file, for the extensions KHR_physics_rigid_bodies and OMI_physics_body.
struct GlbPhysics {
    std::vector<GlbBody> bodies;  // one for each part
    Material material;            // of all bodies
};

/// Writes the members "extensionsUsed" and "extensions" of the file. `firstMesh` is the index of the first hull's mesh;
/// the meshes of hulls are consecutive.
void writePhysicsExtensions(JsonWriter& json, const GlbPhysics& physics, std::uint64_t firstMesh);

/// Writes "scene", "scenes" and "nodes". The node of a body has a child with its mesh, and a child for each hull. Each
/// hull has another node outside the scene, to which its collider refers.
void writePhysicsNodes(JsonWriter& json, std::span<const MeshPart> parts, PartPlacement place,
                       const GlbPhysics& physics);

/// Writes the meshes of hulls as elements of "meshes". The accessors of each, positions and indices, are consecutive
/// from `firstAccessor` on.
void writeHullMeshes(JsonWriter& json, std::span<const MeshPart> parts, const GlbPhysics& physics,
                     std::uint64_t firstAccessor);

}  // namespace rubble
