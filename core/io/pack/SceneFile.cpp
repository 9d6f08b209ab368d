#include "core/io/pack/SceneFile.h"

#include "core/asset/strength/Threshold.h"
#include "core/base/Version.h"
#include "core/io/json/VectorJson.h"
#include "core/io/pack/PackFormat.h"
#include "core/io/project/BondingJson.h"
#include "core/io/project/ShotJson.h"

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
    json.number("height", ground.height);
    json.number("friction", ground.friction);
    json.number("restitution", ground.restitution);
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

void writeSceneInstance(JsonWriter& json, const Project& project, const Instance& instance, const PackNames& pack) {
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
    json.close();
}

}  // namespace

bool hasScene(const Project& project) { return !project.instances.empty() || !project.shots.empty(); }

std::string sceneFileJson(const Project& project, const PackOptions& options) {
    const std::map<AssetVariant, PackNames> names = packNames(project);
    std::set<AssetVariant> used;
    for (const Instance& instance : project.instances) used.insert(variantOf(instance));
    for (const Shot& shot : project.shots) {
        const auto* thrown = std::get_if<Throw>(&shot.action);
        if (thrown != nullptr && thrown->kind == ProjectileKind::Asset) used.insert({thrown->asset, 0});
    }
    JsonWriter json(JsonLayout::CompactLines, 1024 + 300 * project.instances.size());
    json.openObject();
    writeSceneHeader(json);
    writeVector(json, "gravity", project.gravity);
    writeSceneGround(json, project.ground);
    json.openArray("packs", JsonLayout::CompactLines);
    for (const AssetVariant& key : used) writeScenePack(json, project, key, names.at(key), options);
    json.close();
    json.openArray("instances", JsonLayout::CompactLines);
    for (const Instance& instance : project.instances)
        writeSceneInstance(json, project, instance, names.at(variantOf(instance)));
    json.close();
    json.openArray("mortars", JsonLayout::CompactLines);
    for (const Mortar& mortar : project.mortars) writeMortar(json, mortar);
    json.close();
    json.openArray("shots", JsonLayout::CompactLines);
    for (const Shot& shot : project.shots) writeShot(json, shot);
    json.close();
    json.close();
    return std::move(json).finished();
}

}  // namespace rubble
