#include "core/io/exchange/UsdFile.h"

#include "core/base/Assert.h"
#include "core/io/exchange/UsdSurface.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace rubble {
namespace {

/// Masses and moments that are 0 in single precision would mean that they are not given.
constexpr double kMinUsdFloat = double{std::numeric_limits<float>::min()};

/// Writes the prims of a layer, one after the other.
class UsdLayer {
public:
    UsdLayer(const PackBuilder& pack, const MeshMaterials& materials)
        : m_pack(pack.header({})),
          m_materials(materials),
          m_root(m_rootNames.unique(m_pack.names.folder)),
          m_lines(m_root, m_pack.generator) {
        m_lines.begin("Xform", m_root);
        m_lines.setText("custom string rubble:asset", m_pack.names.name);
        m_lines.setText("custom string rubble:physicsHash", m_pack.physicsHash);
        addMaterials();
    }

    void addBody(std::uint32_t index, const PackBody& body, const Mesh& mesh) {
        const std::string path =
            m_lines.begin("Xform", m_names.unique(body.name), {"PhysicsRigidBodyAPI", "PhysicsMassAPI"});
        m_bodies[index] = {path, body.offset};
        m_lines.setText("custom string rubble:id", body.id);
        m_lines.setText("custom string rubble:name", body.name);
        if (body.threshold) m_lines.setDouble("custom double rubble:threshold", *body.threshold);
        addMass(body);
        m_lines.setDoubles("double3 xformOp:translate", body.offset);
        m_lines.setTexts("uniform token[] xformOpOrder", {"xformOp:translate"});
        writeUsdMesh(m_lines, "surface", mesh, m_surfaces);
        for (std::size_t k = 0; k < body.hulls.size(); ++k) addHull(k, body.hulls[k].polytope);
        m_lines.end();
    }

    void addJoints(const PackBonding& bonding) {
        m_lines.begin("Scope", "Joints");
        m_lines.setText("custom string rubble:breakForce",
                        "rubble:capacity / (1/60 s); without it, a bond never breaks");
        for (const PackFracture& fracture : bonding.fractures) {
            for (const PackBond& bond : fracture.bonds) addBond(bond);
        }
        for (const std::uint32_t index : bonding.anchored) addAnchor(index);
        m_lines.end();
    }

    std::string text() && {
        m_lines.end();
        m_lines.begin("PhysicsScene",
                      m_rootNames.unique("PhysicsScene"));  // beside the default prim: not in references
        m_lines.setFloats("vector3f physics:gravityDirection", {0.0, -1.0, 0.0});
        m_lines.setFloat("float physics:gravityMagnitude", 9.81);
        m_lines.end();
        return std::move(m_lines).text();
    }

private:
    struct Placed {
        std::string path;
        Vec3 offset;
    };

    void addMaterials() {
        m_lines.begin("Scope", m_names.unique("Materials"));
        m_names.unique("Joints");
        UsdNames names;
        const Material& own = m_pack.own();
        m_physicsMaterial = m_lines.begin("Material", names.unique(own.name + "_physics"), {"PhysicsMaterialAPI"});
        m_lines.setFloat("float physics:density", own.density);
        m_lines.setFloat("float physics:dynamicFriction", own.friction);
        m_lines.setFloat("float physics:restitution", own.restitution);
        m_lines.setFloat("float physics:staticFriction", own.friction);
        m_lines.end();
        const auto addSurface = [&](const MeshMaterial& material) {
            const BakedImages* baked = material.isBaked ? &*m_materials.baked : nullptr;
            m_surfaces.push_back(writeUsdMaterial(m_lines, names, material, m_materials.imageFile, baked));
        };
        std::ranges::for_each(m_materials.outside, addSurface);
        addSurface(m_materials.inside);
        m_lines.end();
    }

    void addMass(const PackBody& body) {
        RUBBLE_ASSERT(body.principal.has_value());
        m_lines.setFloats("point3f physics:centerOfMass", body.centreOfMass);
        m_lines.setFloats("float3 physics:diagonalInertia", glm::max(body.principal->moments, Vec3(kMinUsdFloat)));
        m_lines.setFloat("float physics:mass", std::max(body.mass, kMinUsdFloat));
        m_lines.setRotation("quatf physics:principalAxes", body.principal->rotation);
    }

    void addHull(std::size_t number, const Polytope& hull) {
        std::vector<std::uint32_t> counts, indices;
        for (const std::vector<std::uint32_t>& face : hull.faces) {
            counts.push_back(static_cast<std::uint32_t>(face.size()));
            indices.insert(indices.end(), face.begin(), face.end());
        }
        m_lines.begin("Mesh", "hull" + std::to_string(number),
                      {"PhysicsCollisionAPI", "PhysicsMeshCollisionAPI", "MaterialBindingAPI"});
        writeUsdFaces(m_lines, counts, indices, hull.vertices);
        m_lines.setTarget("rel material:binding:physics", m_physicsMaterial);
        m_lines.setText("uniform token physics:approximation", "convexHull");
        m_lines.setText("uniform token purpose", "guide");
        m_lines.end();
    }

    /// Bonds of fragments that are not in the layer are left out.
    void addBond(const PackBond& bond) {
        const auto first = m_bodies.find(bond.fragments[0]), second = m_bodies.find(bond.fragments[1]);
        if (first == m_bodies.end() || second == m_bodies.end()) return;
        m_lines.begin("PhysicsFixedJoint",
                      "bond_" + std::to_string(bond.fragments[0]) + "_" + std::to_string(bond.fragments[1]));
        m_lines.setTarget("rel physics:body0", first->second.path);
        m_lines.setTarget("rel physics:body1", second->second.path);
        m_lines.setFloats("point3f physics:localPos0", bond.centroid - first->second.offset);
        m_lines.setFloats("point3f physics:localPos1", bond.centroid - second->second.offset);
        if (bond.capacity) {
            const double most = double{std::numeric_limits<float>::max()};
            m_lines.setFloat("float physics:breakForce", std::min(*bond.capacity / kJointStep, most));
            m_lines.setDouble("custom double rubble:capacity", *bond.capacity);
        }
        m_lines.end();
    }

    void addAnchor(std::uint32_t index) {
        const auto body = m_bodies.find(index);
        if (body == m_bodies.end()) return;
        m_lines.begin("PhysicsFixedJoint", "anchor_" + std::to_string(index));
        m_lines.setTarget("rel physics:body0", "/" + m_root);
        m_lines.setTarget("rel physics:body1", body->second.path);
        m_lines.setFloats("point3f physics:localPos0", body->second.offset);
        m_lines.end();
    }

    Pack m_pack;  // without bodies
    const MeshMaterials& m_materials;
    UsdNames m_rootNames, m_names;
    std::string m_root;
    UsdWriter m_lines;
    std::string m_physicsMaterial;
    std::vector<std::string> m_surfaces;  // paths: outside by MeshFace::material, then that of the inside
    std::map<std::uint32_t, Placed> m_bodies;
};

}  // namespace

Result<std::string> usdFile(const PackBuilder& pack, std::span<const std::uint32_t> bodies,
                            const MeshMaterials& materials, const std::function<Mesh(std::uint32_t)>& meshOf,
                            const TaskContext& task) {
    UsdLayer layer(pack, materials);
    for (const std::uint32_t index : bodies) {
        if (task.isCancelled()) return TaskContext::cancelled();
        layer.addBody(index, index == kNone ? pack.whole() : pack.fragment(index), meshOf(index));
    }
    const bool isWhole = bodies.size() == 1 && bodies[0] == kNone;
    const std::optional<PackBonding> bonding = isWhole ? std::nullopt : pack.bonding();
    if (bonding) layer.addJoints(*bonding);
    return std::move(layer).text();
}

}  // namespace rubble
