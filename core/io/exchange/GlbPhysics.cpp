#include "core/io/exchange/GlbPhysics.h"

#include "core/base/Assert.h"
#include "core/io/exchange/GlbElements.h"
#include "core/io/json/VectorJson.h"

namespace rubble {
namespace {

constexpr const char* kKhrBodies = "KHR_physics_rigid_bodies";
constexpr const char* kOmiBody = "OMI_physics_body";
constexpr const char* kOmiShape = "OMI_physics_shape";

/// The name of the mesh of a hull: "wall_f3_hull0", or in the form that Unreal Engine reads, "UCX_wall_f3_00".
std::string hullName(const MeshPart& part, std::size_t hull, GlbBodyForm form) {
    const std::string number = std::to_string(hull);
    if (form == GlbBodyForm::Extensions) return part.name + "_hull" + number;
    return "UCX_" + part.name + (number.size() < 2 ? "_0" : "_") + number;
}

/// The nodes of a body: its own, that of its mesh, and two for each hull.
std::uint64_t nodeCount(const GlbBody& body) { return 2 + 2 * std::uint64_t{body.body.hulls.size()}; }

/// Writes the only material, which both extensions describe with the same members. Restitutions combine as in Rubble;
/// the mean of frictions is that of Rubble where they are equal.
void writePhysicsMaterials(JsonWriter& json, const Material& material) {
    json.openArray("physicsMaterials");
    json.openObject();
    json.text("name", material.name);
    json.number("staticFriction", material.friction);
    json.number("dynamicFriction", material.friction);
    json.number("restitution", material.restitution);
    json.text("frictionCombine", "average");
    json.text("restitutionCombine", "maximum");
    json.close();
    json.close();
}

/// Writes the members of "motion" that both extensions have.
void writeMotionMembers(JsonWriter& json, const PackBody& body) {
    RUBBLE_ASSERT(body.principal);
    const auto& [moments, rotation] = *body.principal;
    json.number("mass", body.mass);
    writeVector(json, "centerOfMass", body.centreOfMass);
    writeVector(json, "inertiaDiagonal", moments);
    json.numbers("inertiaOrientation", {rotation.x, rotation.y, rotation.z, rotation.w});
}

void writeMotions(JsonWriter& json, const PackBody& body) {
    json.openObject("extensions");
    json.openObject(kKhrBodies);
    json.openObject("motion");
    writeMotionMembers(json, body);
    json.close();
    json.close();
    json.openObject(kOmiBody);
    json.openObject("motion");
    json.text("type", "dynamic");
    writeMotionMembers(json, body);
    json.close();
    json.close();
    json.close();
}

void writeBodyExtras(JsonWriter& json, const GlbBody& body) {
    json.openObject("extras");
    json.openObject("rubble");
    json.text("id", body.body.id);
    if (body.parent.empty()) json.null("parent");
    if (!body.parent.empty()) json.text("parent", body.parent);
    json.wholeNumber("level", std::uint64_t{body.body.level});
    if (body.body.threshold) json.number("threshold", *body.body.threshold);
    json.close();
    json.close();
}

/// Writes the node of a body, which has the index `node`. It has no mesh: Godot ignores that of a body.
void writeBodyNode(JsonWriter& json, const MeshPart& part, PartPlacement place, const GlbBody& body,
                   std::uint64_t node) {
    json.openObject();
    json.text("name", part.name);
    if (place == PartPlacement::Assembled) writeVector(json, "translation", part.offset);
    json.openArray("children");
    json.wholeNumber({}, node + 1);
    for (std::uint64_t k = 2; k < nodeCount(body); k += 2) json.wholeNumber({}, node + k);
    json.close();
    writeMotions(json, body.body);
    writeBodyExtras(json, body);
    json.close();
}

void writeMeshNode(JsonWriter& json, const std::string& name, std::uint64_t mesh) {
    json.openObject();
    json.text("name", name);
    json.wholeNumber("mesh", mesh);
    json.close();
}

/// Writes the node of a collider: readers of KHR_physics_rigid_bodies take the mesh or the node, by their version.
void writeColliderNode(JsonWriter& json, const std::string& name, std::uint64_t mesh, std::uint64_t meshNode,
                       std::uint64_t shape) {
    json.openObject();
    json.text("name", name);
    json.openObject("extensions");
    json.openObject(kKhrBodies);
    json.openObject("collider");
    json.openObject("geometry");
    json.wholeNumber("mesh", mesh);
    json.wholeNumber("node", meshNode);
    json.boolean("convexHull", true);
    json.close();
    json.wholeNumber("physicsMaterial", std::uint64_t{0});
    json.wholeNumber("collisionFilter", std::uint64_t{0});
    json.close();
    json.close();
    json.openObject(kOmiBody);
    json.openObject("collider");
    json.wholeNumber("shape", shape);
    json.wholeNumber("physicsMaterial", std::uint64_t{0});
    json.close();
    json.close();
    json.close();
    json.close();
}

void writeBodyScene(JsonWriter& json, const GlbPhysics& physics) {
    json.wholeNumber("scene", std::uint64_t{0});
    json.openArray("scenes");
    json.openObject();
    json.openArray("nodes");
    std::uint64_t node = 0;
    for (const GlbBody& body : physics.bodies) {
        json.wholeNumber({}, node);
        node += nodeCount(body);
    }
    json.close();
    json.close();
    json.close();
}

void writePlacedNode(JsonWriter& json, const std::string& name, const MeshPart& part, PartPlacement place,
                     std::uint64_t mesh) {
    json.openObject();
    json.text("name", name);
    json.wholeNumber("mesh", mesh);
    if (place == PartPlacement::Assembled) writeVector(json, "translation", part.offset);
    json.close();
}

/// Writes a node for each part and, behind them, for each hull, which has the place of its part.
void writeNamedNodes(JsonWriter& json, std::span<const MeshPart> parts, PartPlacement place,
                     const GlbPhysics& physics) {
    std::uint64_t hulls = 0;
    for (const GlbBody& body : physics.bodies) hulls += body.body.hulls.size();
    writeGlbScene(json, parts.size() + hulls);
    json.openArray("nodes");
    std::uint64_t mesh = 0;
    for (const MeshPart& part : parts) writePlacedNode(json, part.name, part, place, mesh++);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        for (std::size_t hull = 0; hull < physics.bodies[k].body.hulls.size(); ++hull)
            writePlacedNode(json, hullName(parts[k], hull, physics.form), parts[k], place, mesh++);
    }
    json.close();
}

void writeHullShapes(JsonWriter& json, const GlbPhysics& physics, std::uint64_t mesh) {
    json.openObject(kOmiShape);
    json.openArray("shapes");
    for (const GlbBody& body : physics.bodies) {
        for (std::size_t k = 0; k < body.body.hulls.size(); ++k) {
            json.openObject();
            json.text("type", "convex");
            json.openObject("convex");
            json.wholeNumber("mesh", mesh++);
            json.close();
            json.close();
        }
    }
    json.close();
    json.close();
}

}  // namespace

void writePhysicsExtensions(JsonWriter& json, const GlbPhysics& physics, std::uint64_t firstMesh) {
    json.openArray("extensionsUsed");
    // KHR_physics_rigid_bodies depends on the first.
    for (const char* name : {"KHR_implicit_shapes", kKhrBodies, kOmiBody, kOmiShape}) json.text({}, name);
    json.close();
    json.openObject("extensions");
    json.openObject(kKhrBodies);
    writePhysicsMaterials(json, physics.material);
    json.openArray("collisionFilters");
    json.openObject();
    json.openArray("collisionSystems");
    json.text({}, "fragments");
    json.close();
    json.close();
    json.close();
    json.close();
    writeHullShapes(json, physics, firstMesh);
    json.openObject(kOmiBody);
    writePhysicsMaterials(json, physics.material);
    json.close();
    json.close();
}

void writePhysicsNodes(JsonWriter& json, std::span<const MeshPart> parts, PartPlacement place,
                       const GlbPhysics& physics) {
    RUBBLE_ASSERT(parts.size() == physics.bodies.size());
    if (physics.form == GlbBodyForm::Names) return writeNamedNodes(json, parts, place, physics);
    writeBodyScene(json, physics);
    json.openArray("nodes");
    std::uint64_t node = 0, shape = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const GlbBody& body = physics.bodies[k];
        writeBodyNode(json, parts[k], place, body, node);
        writeMeshNode(json, parts[k].name + "_mesh", std::uint64_t{k});
        for (std::size_t hull = 0; hull < body.body.hulls.size(); ++hull, ++shape) {
            const std::string name = hullName(parts[k], hull, physics.form);
            writeColliderNode(json, name, parts.size() + shape, node + 3 + 2 * hull, shape);
            writeMeshNode(json, name + "_shape", parts.size() + shape);
        }
        node += nodeCount(body);
    }
    json.close();
}

void writeHullMeshes(JsonWriter& json, std::span<const MeshPart> parts, const GlbPhysics& physics,
                     std::uint64_t firstAccessor) {
    std::uint64_t accessor = firstAccessor;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        for (std::size_t hull = 0; hull < physics.bodies[k].body.hulls.size(); ++hull, accessor += 2) {
            json.openObject();
            json.text("name", hullName(parts[k], hull, physics.form));
            json.openArray("primitives");
            json.openObject();
            json.openObject("attributes");
            json.wholeNumber("POSITION", accessor);
            json.close();
            json.wholeNumber("indices", accessor + 1);
            json.close();
            json.close();
            json.close();
        }
    }
}

}  // namespace rubble
