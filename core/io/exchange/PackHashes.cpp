#include "core/asset/bake/BakeHash.h"
#include "core/asset/strength/BondStrength.h"
#include "core/asset/strength/Threshold.h"
#include "core/io/exchange/PackBuilder.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/project/BondingJson.h"

namespace rubble {
namespace {

/// To be increased when the bodies of equal inputs change.
constexpr std::uint64_t kPackRevision = 2;

void addText(Hasher& hasher, std::string_view text) {
    hasher.add(std::uint64_t{text.size()});
    hasher.add(text);
}

void addOptional(Hasher& hasher, const std::optional<double>& number) {
    hasher.add(std::uint64_t{number.has_value()});
    hasher.add(number.value_or(0.0));
}

void addFragmentThresholds(Hasher& hasher, const Asset& asset) {
    const auto add = [&](std::string_view of, double threshold) {
        addText(hasher, of);
        hasher.add(threshold);
    };
    for (std::size_t k = 0; k < asset.levels.size(); ++k) {
        if (asset.levels[k].threshold) add("level " + std::to_string(k), *asset.levels[k].threshold);
    }
    for (const FragmentLevel& leaf : asset.fragmentLevels) {
        if (leaf.level && leaf.level->threshold) add("leaf " + leaf.fragment, *leaf.level->threshold);
    }
    for (const FragmentThreshold& own : asset.fragmentThresholds) add(own.fragment, own.threshold);
}

void addBonding(Hasher& hasher, const Asset& asset, const Material& material) {
    if (asset.breakAs != BreakAs::Bonded) return;
    Asset resolved = asset;
    resolved.bonding.impulsePerArea = bondImpulseOf(asset, material);
    JsonWriter json(JsonLayout::Inline);  // keeps the signs of zeros
    json.openObject();
    writeBonding(json, resolved);
    json.close();
    addText(hasher, std::move(json).contents());
    for (const Level& level : asset.levels) hasher.add(level.bondStrength);
    for (const FragmentLevel& leaf : asset.fragmentLevels) {
        if (leaf.level) hasher.add(leaf.level->bondStrength);
    }
}

void addPhysics(Hasher& hasher, const Asset& asset, const Material& material, const PackSettings& settings) {
    hasher.add(kPackRevision);
    addText(hasher, bakeInputHash(asset).hex());
    hasher.add(thresholdOf(asset, material));
    addFragmentThresholds(hasher, asset);
    addBonding(hasher, asset, material);
    hasher.add(std::uint64_t{asset.cutAtImpact.has_value()});
    if (asset.cutAtImpact) {
        hasher.add(std::uint64_t{asset.cutAtImpact->fragments});
        hasher.add(asset.cutAtImpact->falloffRadius);
    }
    for (const double value : {material.density, material.friction, material.restitution}) hasher.add(value);
    hasher.add(settings.inset);
    hasher.add(static_cast<std::uint64_t>(settings.rule));
    hasher.add(std::uint64_t{settings.debris.has_value()});
    if (!settings.debris) return;
    addOptional(hasher, settings.debris->lifetime);
    hasher.add(settings.debris->fade);
    hasher.add(std::uint64_t{settings.debris->maxFragments.value_or(0)});
}

void addColour(Hasher& hasher, const Colour& colour) {
    for (const double value : {colour.red, colour.green, colour.blue}) hasher.add(value);
}

void addMaterial(Hasher& hasher, const Material& material) {
    addText(hasher, material.name);
    for (const double value : {material.density, material.friction, material.restitution, material.opacity})
        hasher.add(value);
    for (const std::optional<double>& value :
         {material.tensileStrength, material.fractureToughness, material.youngsModulus})
        addOptional(hasher, value);
    addColour(hasher, material.outside);
    addColour(hasher, material.inside);
}

void addMeshes(Hasher& hasher, std::span<const PackMeshFile> meshes) {
    for (const PackMeshFile& mesh : meshes) {
        addText(hasher, mesh.name);
        hasher.add(static_cast<std::uint64_t>(mesh.bodies));
        hasher.add(std::uint64_t{mesh.fragment});
        hasher.add(static_cast<std::uint64_t>(mesh.place));
        hasher.add(std::uint64_t{mesh.level.value_or(kNone)});
    }
}

}  // namespace

PackHashes packHashes(const Asset& asset, const AssetMaterials& material, const PackNames& names,
                      const PackSettings& settings, std::span<const PackMeshFile> meshes) {
    Hasher physics;
    addPhysics(physics, asset, material.own, settings);
    Hasher all;
    const ContentHash ofPhysics = physics.digest();
    addText(all, ofPhysics.hex());
    for (const std::string& name : {names.name, names.base, names.folder}) addText(all, name);
    addMaterial(all, material.own);
    addMaterial(all, material.inside);
    for (const PackSurface& surface : packSurfaces(asset, material)) {
        addText(all, surface.name);
        addText(all, surface.texture);
    }
    addMeshes(all, meshes);
    return {all.digest(), ofPhysics};
}

}  // namespace rubble
