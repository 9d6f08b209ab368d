#include "core/io/pack/SceneFile.h"

#include "core/asset/strength/Threshold.h"
#include "core/base/Hash.h"
#include "core/base/MessageText.h"
#include "core/base/Version.h"
#include "core/io/json/FormatVersion.h"
#include "core/io/json/JsonDocument.h"
#include "core/io/json/VectorJson.h"
#include "core/io/pack/PackFormat.h"
#include "core/io/project/BondingJson.h"
#include "core/io/project/SceneJson.h"
#include "core/io/project/ShotJson.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace rubble {
namespace {

constexpr FileFormat kSceneFormat{.name = "rubble-scene", .noun = "scene", .version = 1};

void writeSceneHeader(JsonWriter& json) {
    json.text("format", kSceneFormat.name);
    json.wholeNumber("version", std::uint64_t{kSceneFormat.version});
    json.text("generator", std::string("Rubble ") + programVersion());
    writeUnits(json);
    json.openObject("axes");
    json.text("handedness", "right");
    json.text("up", "y");
    json.close();
}

void writeSceneGround(JsonWriter& json, const Ground& ground) {
    if (!ground.isOn) return;
    json.openObject("ground");
    writeGroundPlane(json, ground);
    json.close();
}

/// What a pack is called, with the hash by which a reader knows whether it is the one of this scene.
void writeScenePack(JsonWriter& json, const Project& project, const AssetVariant& key, const PackNames& names,
                    const PackOptions& options) {
    const Asset asset = variantOf(*findAsset(project, key.asset), key.variant);
    json.openObject();
    json.text("folder", names.folder);
    json.wholeNumber("asset", std::uint64_t{key.asset});
    json.wholeNumber("variant", std::uint64_t{key.variant});
    json.text("physicsHash",
              packHashes(asset, materialsOf(project, asset), names, packSettings(project, options), {}).physics.hex());
    json.close();
}

/// What a bond to something fixed, or a joint, has in common with the bonds of packs.
void writeFace(JsonWriter& json, double area, Vec3 centroid, Vec3 normal, double capacity) {
    json.number("area", area);
    writeVector(json, "centroid", centroid);
    writeVector(json, "normal", normal);
    json.number("capacity", std::isfinite(capacity) ? std::optional(capacity) : std::nullopt);
}

/// The bonds of an instance to what is fixed, without those that are mortar.
void writeAnchors(JsonWriter& json, const PlayStructure& structure) {
    if (structure.holdsHeaviest) json.boolean("holdsHeaviest", true);
    json.openArray("anchors");
    for (std::uint32_t bond = 0; bond < structure.firstMortar(); ++bond) {
        const Bond& anchor = structure.graph.bonds[bond];
        if (anchor.second != kNone) continue;
        json.openObject();
        json.wholeNumber("fragment", std::uint64_t{structure.fragmentOf(anchor.first)});
        writeFace(json, anchor.area, anchor.centroid, anchor.normal, structure.capacities[bond]);
        json.close();
    }
    json.close();
}

void writeJoint(JsonWriter& json, const PlayScene& played, const Mortar& mortar, const MortarJoint& joint) {
    const auto fragmentOf = [&](Id instance, std::uint32_t node) {
        return played.structures.at(instance)->fragmentOf(node);
    };
    std::vector<std::uint32_t> instances{joint.first}, fragments{fragmentOf(joint.first, joint.nodes[0])};
    if (joint.second != 0) {
        instances.push_back(joint.second);
        fragments.push_back(fragmentOf(joint.second, joint.nodes[1]));
    }
    json.openObject();
    json.wholeNumber("mortar", std::uint64_t{mortar.id});
    json.wholeNumbers("instances", instances);
    json.wholeNumbers("fragments", fragments);
    writeFace(json, joint.area, joint.centroid, joint.normal, mortar.impulsePerArea * joint.area);
    json.close();
}

/// The mortar that holds: between instances of which one is anchored.
void writeJoints(JsonWriter& json, const PlayScene& played) {
    json.openArray("joints", JsonLayout::CompactLines);
    for (std::size_t k = 0; k < played.mortars.size(); ++k) {
        for (const MortarJoint& joint : played.mortars[k].joints) {
            if (played.structures.at(joint.first)->joined != nullptr)
                writeJoint(json, played, played.project.mortars[k], joint);
        }
    }
    json.close();
}

void writeSceneInstance(JsonWriter& json, const Project& project, const Instance& instance, const PackNames& pack,
                        const PlayScene* played) {
    const Asset& asset = *findAsset(project, instance.asset);
    const Quat& q = instance.pose.orientation;
    json.openObject();
    json.wholeNumber("id", std::uint64_t{instance.id});
    json.text("name", instance.name);
    json.text("pack", pack.folder);
    writeVector(json, "position", instance.pose.position);
    json.numbers("rotation", {q.x, q.y, q.z, q.w});
    json.number("threshold", instance.threshold.value_or(thresholdOf(project, asset)));
    json.boolean("fixed", instance.isFixed);
    json.boolean("unbreakable", instance.isUnbreakable);
    json.boolean("anchored", instance.isAnchored);
    json.number("bondStrength", instance.bondStrength);
    if (played != nullptr) {
        const auto structure = played->structures.find(instance.id);
        if (structure != played->structures.end()) writeAnchors(json, *structure->second);
    }
    json.close();
}

}  // namespace

bool hasScene(const Project& project) { return !project.instances.empty() || !project.shots.empty(); }

bool hasSceneBonds(const Project& project) {
    return std::ranges::any_of(project.instances, [&](const Instance& instance) {
        return !instance.isUnbreakable && findAsset(project, instance.asset)->breakAs == BreakAs::Bonded;
    });
}

ContentHash sceneSource(const Project& project, const PackOptions& options) {
    return contentHash(sceneFileJson(project, options));
}

std::optional<std::string> scenePacksFault(std::string_view json, const PackPhysicsHashes& present) {
    Result<JsonDocument> document = JsonDocument::parse(json);
    if (!document) return document.error().message;
    if (const Result<std::uint32_t> version = versionOf(*document, kSceneFormat); !version)
        return version.error().message;
    PackPhysicsHashes named;
    for (const auto& [folder, hash] : document->root()["packs"].list(
             [](const JsonValue& pack) { return std::pair(pack["folder"].text(), pack["physicsHash"].text()); }))
        named[folder] = hash;
    if (const std::optional<Error> fault = document->firstError()) return fault->message;
    for (const auto& [folder, hash] : named) {
        const auto found = present.find(folder);
        if (found == present.end()) return "There is no pack " + quotedName(folder) + ", which the scene uses.";
        if (found->second == hash) continue;
        return "The pack " + quotedName(folder) + " is of another export than the scene; export all assets again.";
    }
    return std::nullopt;
}

std::string sceneFileJson(const Project& project, const PackOptions& options, const PlayScene* played) {
    const std::map<AssetVariant, PackNames> names = packNames(project, options);
    std::set<AssetVariant> used;
    for (const Instance& instance : project.instances) used.insert(variantOf(instance));
    for (const Shot& shot : project.shots) {
        const auto* thrown = std::get_if<Throw>(&shot.action);
        if (thrown != nullptr && thrown->kind == ProjectileKind::Asset) used.insert({thrown->asset, 0});
    }
    JsonWriter json(JsonLayout::CompactLines, 1024 + 300 * project.instances.size());
    json.openObject();
    writeSceneHeader(json);
    if (played != nullptr) json.text("source", sceneSource(project, options).hex());
    writeVector(json, "gravity", project.gravity);
    writeSceneGround(json, project.ground);
    json.openArray("packs", JsonLayout::CompactLines);
    for (const AssetVariant& key : used) writeScenePack(json, project, key, names.at(key), options);
    json.close();
    json.openArray("instances", JsonLayout::CompactLines);
    for (const Instance& instance : project.instances)
        writeSceneInstance(json, project, instance, names.at(variantOf(instance)), played);
    json.close();
    json.openArray("mortars", JsonLayout::CompactLines);
    for (const Mortar& mortar : project.mortars) writeMortar(json, mortar);
    json.close();
    if (played != nullptr) writeJoints(json, *played);
    json.openArray("shots", JsonLayout::CompactLines);
    for (const Shot& shot : project.shots) writeShot(json, shot);
    json.close();
    json.close();
    return std::move(json).finished();
}

}  // namespace rubble
