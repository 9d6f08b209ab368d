// Tests core/io/exchange/GlbPhysics.cpp, and what GlbBuffer.cpp and PackMeshes.cpp do for it.
#include "core/io/exchange/GlbPhysics.h"
#include "core/io/pack/PackMeshes.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"
#include "tests/support/files/GlbReading.h"
#include "tests/support/files/Schemas.h"
#include "tests/support/files/TestImages.h"

#include <QTest>

#include <algorithm>
#include <set>

using namespace rubble;

namespace {

using Json = nlohmann::json;

const Material kStone{.id = 1, .name = "stone", .density = 2500.0, .friction = 0.7, .restitution = 0.25};
const char* const kKhr = "KHR_physics_rigid_bodies";
const char* const kOmi = "OMI_physics_body";

/// The ring, whose fragments have several hulls and two levels, its GLB files with physics by name, and its pack.
struct PhysicsExport {
    explicit PhysicsExport(MeshOptions options = {}, Asset exported = ringAsset()) : asset(std::move(exported)) {
        options.formats.erase("obj");
        const Bake baked = bake(asset).value();
        const PackInput input{baked, asset, {kStone, kStone}, packNames(asset), {}};
        pack = packOf(input, {});
        const PackMeshes meshes = packMeshes(PackBuilder(input), options).value();
        for (const ExportFile& file : meshes.files) {
            const std::string fault = openGlb(file.bytes, files[file.name]);
            if (!fault.empty()) qWarning("%s: %s", file.name.c_str(), fault.c_str());
        }
    }
    const PackBody& bodyNamed(const std::string& name) const {
        const auto found = std::ranges::find(pack.fragments, name, &PackBody::name);
        return found == pack.fragments.end() ? pack.whole : *found;
    }
    Asset asset;
    Pack pack;
    std::map<std::string, Glb> files;
};

const PhysicsExport& ring() {
    static const PhysicsExport ring({.glbKind = GlbKind::Physics});
    return ring;
}

/// The nodes of bodies in a file: the roots of its scene.
std::vector<Json> bodyNodes(const Glb& glb) {
    std::vector<Json> nodes;
    for (const std::size_t node : glb.json["scenes"][0]["nodes"]) nodes.push_back(glb.json["nodes"][node]);
    return nodes;
}

/// The colliders of a body: its children but the first.
std::vector<Json> colliderNodes(const Glb& glb, const Json& body) {
    std::vector<Json> nodes;
    for (std::size_t k = 1; k < body["children"].size(); ++k)
        nodes.push_back(glb.json["nodes"][body["children"][k].get<std::size_t>()]);
    return nodes;
}

std::vector<float> floatsOf(const std::vector<Vec3>& points) {
    std::vector<float> floats;
    for (const Vec3& point : points) {
        for (const double value : {point.x, point.y, point.z}) floats.push_back(static_cast<float>(value));
    }
    return floats;
}

Json vectorOf(Vec3 vector) { return {vector.x, vector.y, vector.z}; }

/// Six times the volume of a hull's triangles.
double sixfoldVolume(const std::vector<float>& positions, const std::vector<std::uint32_t>& indices) {
    const auto point = [&](std::size_t k) {
        const float* p = &positions[3 * std::size_t{indices[k]}];
        return Vec3{p[0], p[1], p[2]};
    };
    double volume = 0.0;
    for (std::size_t k = 0; k < indices.size(); k += 3)
        volume += glm::dot(point(k), glm::cross(point(k + 1), point(k + 2)));
    return volume;
}

double sixfoldVolume(const Polytope& hull) {
    double volume = 0.0;
    for (const std::vector<std::uint32_t>& face : hull.faces) {
        for (std::size_t k = 2; k < face.size(); ++k) {
            volume += glm::dot(hull.vertices[face[0]], glm::cross(hull.vertices[face[k - 1]], hull.vertices[face[k]]));
        }
    }
    return volume;
}

}  // namespace

class GlbPhysicsTest : public QObject {
    Q_OBJECT
private slots:
    void filesFitTheSchema() {
        const test::Schema schema("glb-physics.schema.json");
        QCOMPARE(ring().files.size(), std::size_t{3});
        for (const auto& [name, glb] : ring().files) QCOMPARE(schema.fault(glb.json), std::string());
        Json wrong = ring().files.at("old_ring-intact.glb").json;
        wrong["nodes"][0]["extensions"][kKhr]["motion"]["mass"] = 0;  // which would be infinite
        QVERIFY(!schema.fault(wrong).empty());
        wrong = ring().files.at("old_ring-intact.glb").json;
        wrong["nodes"][0]["mesh"] = 0;
        QVERIFY(!schema.fault(wrong).empty());
    }
    void everyBodyIsInOneFile() {
        std::multiset<std::string> names;
        for (const auto& [name, glb] : ring().files) {
            for (const Json& node : bodyNodes(glb)) names.insert(node["name"].get<std::string>());
        }
        std::multiset<std::string> expected{ring().pack.whole.name};
        for (const PackBody& body : ring().pack.fragments) expected.insert(body.name);
        QVERIFY(names == expected);
    }
    void motionsAreThoseOfThePack() {
        for (const auto& [name, glb] : ring().files) {
            for (const Json& node : bodyNodes(glb)) {
                const PackBody& body = ring().bodyNamed(node["name"]);
                const Quat& rotation = body.principal->rotation;
                Json expected{{"mass", body.mass},
                              {"centerOfMass", vectorOf(body.centreOfMass)},
                              {"inertiaDiagonal", vectorOf(body.principal->moments)},
                              {"inertiaOrientation", {rotation.x, rotation.y, rotation.z, rotation.w}}};
                QVERIFY(node["extensions"][kKhr]["motion"] == expected);
                expected["type"] = "dynamic";
                QVERIFY(node["extensions"][kOmi]["motion"] == expected);
                QVERIFY(node["translation"] == vectorOf(body.offset));
            }
        }
    }
    void extrasSayWhatABodyIsAFragmentOf() {
        std::size_t ofFragments = 0, breaking = 0;
        for (const auto& [name, glb] : ring().files) {
            for (const Json& node : bodyNodes(glb)) {
                const Json& extras = node["extras"]["rubble"];
                const PackBody& body = ring().bodyNamed(node["name"]);
                QVERIFY(extras["id"] == body.id);
                QVERIFY(extras["level"] == body.level);
                QCOMPARE(extras.contains("threshold"), body.threshold.has_value());
                if (body.threshold) QVERIFY(extras["threshold"] == *body.threshold);
                breaking += body.threshold ? 1 : 0;
                ofFragments += body.parent == kNone ? 0 : 1;
                if (&body == &ring().pack.whole)
                    QVERIFY(extras["parent"].is_null());
                else
                    QVERIFY(extras["parent"] ==
                            (body.parent == kNone ? ring().pack.whole : ring().pack.fragments[body.parent]).id);
            }
        }
        QVERIFY(ofFragments > 0 && breaking > 1);
    }
    void hullsAreThoseOfThePack() {
        std::size_t several = 0;
        for (const auto& [name, glb] : ring().files) {
            for (const Json& node : bodyNodes(glb)) {
                const PackBody& body = ring().bodyNamed(node["name"]);
                const std::vector<Json> colliders = colliderNodes(glb, node);
                QCOMPARE(colliders.size(), body.hulls.size());
                several += colliders.size() > 1 ? 1 : 0;
                for (std::size_t k = 0; k < colliders.size(); ++k) {
                    const Json& collider = colliders[k]["extensions"][kKhr]["collider"];
                    const Json& mesh = glb.json["meshes"][collider["geometry"]["mesh"].get<std::size_t>()];
                    QCOMPARE(mesh["primitives"].size(), std::size_t{1});
                    const Json& primitive = mesh["primitives"][0];
                    QCOMPARE(primitive.size(), std::size_t{2});  // no material
                    QCOMPARE(primitive["attributes"].size(), std::size_t{1});
                    const Json& accessors = glb.json["accessors"];
                    const Json& accessor = accessors[primitive["attributes"]["POSITION"].get<std::size_t>()];
                    const auto positions = numbersOf<float>(glb, accessor);
                    const Polytope& hull = body.hulls[k].polytope;
                    QVERIFY(positions == floatsOf(hull.vertices));
                    const auto indices =
                        numbersOf<std::uint32_t>(glb, accessors[primitive["indices"].get<std::size_t>()]);
                    QVERIFY(std::ranges::all_of(indices,
                                                [&](std::uint32_t index) { return index < hull.vertices.size(); }));
                    // Floats have seven digits.
                    QVERIFY(std::abs(sixfoldVolume(positions, indices) / sixfoldVolume(hull) - 1.0) < 1e-4);
                    QVERIFY(body.hulls[k].inset > 0.0);
                }
            }
        }
        QVERIFY(several > 0);
    }
    void collidersReferToNodesOutsideTheScene() {
        for (const auto& [name, glb] : ring().files) {
            std::set<std::size_t> shapes, inScene;
            for (const std::size_t root : glb.json["scenes"][0]["nodes"]) {
                inScene.insert(root);
                for (const std::size_t child : glb.json["nodes"][root]["children"]) inScene.insert(child);
            }
            std::set<std::size_t> outside;
            for (const Json& node : bodyNodes(glb)) {
                for (const Json& collider : colliderNodes(glb, node)) {
                    const Json& geometry = collider["extensions"][kKhr]["collider"]["geometry"];
                    const std::size_t own = geometry["node"];
                    QVERIFY(outside.insert(own).second && !inScene.contains(own));
                    QVERIFY(glb.json["nodes"][own]["mesh"] == geometry["mesh"]);
                    const std::size_t shape = collider["extensions"][kOmi]["collider"]["shape"];
                    QVERIFY(shapes.insert(shape).second);
                    QVERIFY(glb.json["extensions"]["OMI_physics_shape"]["shapes"][shape]["convex"]["mesh"] ==
                            geometry["mesh"]);
                }
            }
            QCOMPARE(outside.size() + inScene.size(), glb.json["nodes"].size());
            QCOMPARE(shapes.size(), glb.json["extensions"]["OMI_physics_shape"]["shapes"].size());
        }
    }
    void materialsHaveFrictionAndRestitution() {
        const Json& extensions = ring().files.at("old_ring-fragments.glb").json["extensions"];
        const Json expected = Json::parse(
            R"([{"name":"stone","staticFriction":0.7,"dynamicFriction":0.7,"restitution":0.25,
                 "frictionCombine":"average","restitutionCombine":"maximum"}])");
        QVERIFY(extensions[kKhr]["physicsMaterials"] == expected);
        QVERIFY(extensions[kOmi]["physicsMaterials"] == expected);
    }
    void meshesAreThoseOfFilesWithoutPhysics() {
        const PhysicsExport plain;
        for (const auto& [name, glb] : ring().files) {
            const Glb& other = plain.files.at(name);
            for (const char* member : {"extensions", "extensionsUsed"}) QVERIFY(!other.json.contains(member));
            const std::vector<Json> bodies = bodyNodes(glb);
            QCOMPARE(bodies.size(), other.json["nodes"].size());
            for (std::size_t k = 0; k < bodies.size(); ++k) {
                const Json& before = other.json["nodes"][k];
                QVERIFY(bodies[k]["name"] == before["name"] && bodies[k]["translation"] == before["translation"]);
                const Json& child = glb.json["nodes"][bodies[k]["children"][0].get<std::size_t>()];
                QVERIFY(child["mesh"] == before["mesh"]);
            }
            for (std::size_t k = 0; k < bodies.size(); ++k) QVERIFY(glb.json["meshes"][k] == other.json["meshes"][k]);
            // The arrays of hulls are behind those of the meshes, which have four views.
            QCOMPARE(glb.json["bufferViews"].size(), std::size_t{6});
            const std::size_t size = glb.json["bufferViews"][4]["byteOffset"];
            QVERIFY(glb.binary.substr(0, size) == other.binary.substr(0, size));
        }
    }
    void centredBodiesHaveNoTranslation() {
        const PhysicsExport centred({.place = PartPlacement::Centred, .glbKind = GlbKind::Physics});
        for (const Json& node : bodyNodes(centred.files.at("old_ring-fragments.glb")))
            QVERIFY(!node.contains("translation"));
    }
    void filesOfOneFragmentHaveItsBody() {
        const PhysicsExport each({.split = FileSplit::PerFragment, .glbKind = GlbKind::Physics});
        QCOMPARE(each.files.size(), each.pack.fragments.size() + 1);
        const PackBody& last = each.pack.fragments.back();
        const std::vector<Json> nodes = bodyNodes(each.files.at(last.name + ".glb"));
        QCOMPARE(nodes.size(), std::size_t{1});
        QVERIFY(nodes[0]["extras"]["rubble"]["id"] == last.id);
    }
    void hullsByNameAreMeshesBesideTheirBodies() {
        const PhysicsExport named({.glbKind = GlbKind::Named});
        const Glb& glb = named.files.at("old_ring-fragments.glb");
        QVERIFY(!glb.json.contains("extensionsUsed"));
        std::map<std::string, Json> nodes;
        for (const Json& node : bodyNodes(glb)) nodes[node["name"]] = node;
        std::size_t count = 0;
        for (const PackBody& body : named.pack.fragments) {
            if (!nodes.contains(body.name)) continue;  // it breaks further: in another file
            for (std::size_t hull = 0; hull < body.hulls.size(); ++hull) {
                const std::string name = "UCX_" + body.name + "_0" + std::to_string(hull);
                QVERIFY2(nodes.contains(name), name.c_str());
                const Json& node = nodes[name];
                QVERIFY(node["translation"] == nodes[body.name]["translation"]);
                const Json& mesh = glb.json["meshes"][node["mesh"].get<std::size_t>()];
                QVERIFY(mesh["name"] == name);
                const std::size_t positions = mesh["primitives"][0]["attributes"]["POSITION"];
                QCOMPARE(glb.json["accessors"][positions]["count"].get<std::size_t>(),
                         body.hulls[hull].polytope.vertices.size());
                ++count;
            }
            ++count;
        }
        QCOMPARE(nodes.size(), count);
    }
    void texturesAreBehindTheHulls() {
        Asset asset = ringAsset();
        const auto image = std::make_shared<const EncodedImage>(imageOf(checkerPng()));
        asset.texture = Texture{.name = "checker.png", .image = image, .materials = {0}};
        const PhysicsExport textured({.glbKind = GlbKind::Physics}, asset);
        const Glb& glb = textured.files.at("old_ring-fragments.glb");
        const Json& view = glb.json["bufferViews"][glb.json["images"][0]["bufferView"].get<std::size_t>()];
        QVERIFY(glb.binary.substr(view["byteOffset"], view["byteLength"]) == image->bytes());
    }
};

RUBBLE_TEST(GlbPhysicsTest)
#include "GlbPhysicsTest.moc"
