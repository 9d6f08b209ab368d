#include "core/io/pack/PackFile.h"

#include "core/asset/bake/BakeHash.h"
#include "core/asset/strength/FragmentThreshold.h"
#include "core/asset/strength/Threshold.h"
#include "core/base/Parallel.h"
#include "core/io/pack/PackBodyJson.h"
#include "core/io/pack/PackBondingJson.h"
#include "core/io/pack/PackFormat.h"
#include "core/io/project/ColourJson.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr std::size_t kChunk = 64;  // bodies of a task

void writePackMaterial(JsonWriter& json, const AssetMaterials& material) {
    json.openObject("material");
    json.text("name", material.own.name);
    json.number("density", material.own.density);
    json.number("friction", material.own.friction);
    json.number("restitution", material.own.restitution);
    writeColour(json, "outside", material.own.outside);
    writeColour(json, "inside", material.inside.inside);
    json.close();
}

void writeMesh(JsonWriter& json, const PackMeshFile& mesh) {
    json.openObject();
    json.text("file", mesh.name);
    json.text("bodies", kMeshBodies[static_cast<std::size_t>(mesh.bodies)]);
    json.wholeNumber("fragment", mesh.fragment == kNone ? std::nullopt : std::optional{mesh.fragment});
    json.text("place", kMeshPlaces[static_cast<std::size_t>(mesh.place)]);
    json.close();
}

void writeUnits(JsonWriter& json) {
    json.openObject("units");
    json.text("length", "m");
    json.text("mass", "kg");
    json.text("time", "s");
    json.close();
    json.openObject("axes");
    json.text("handedness", "right");
    json.text("up", "y");
    json.text("front", "counter-clockwise");
    json.close();
}

/// Returns the widest gap between the fragments of a body, m; 0: there is none.
double widestGap(const Bake& bake) {
    double widest = 0.0;
    for (const BakedFracture& fracture : bake.fractures) widest = std::max(widest, fracture.fragments.gap);
    return widest;
}

void writeHeader(JsonWriter& json, const Bake& bake, const Asset& asset, const AssetMaterials& material,
                 std::span<const PackMeshFile> meshes) {
    json.text("format", kPackFormat.name);
    json.wholeNumber("version", std::uint64_t{kPackVersion});
    writeUnits(json);
    json.openObject("asset");
    json.wholeNumber("id", std::uint64_t{asset.id});
    json.text("name", asset.name);
    if (const double gap = widestGap(bake); gap > 0.0) json.number("gap", gap);
    json.close();
    json.text("hash", packHash(asset, material, meshes).hex());
    json.text("checksum", kNoChecksum);
    json.number("threshold", thresholdOf(asset, material.own));
    writePackMaterial(json, material);
    json.openArray("meshes", JsonLayout::CompactLines);
    for (const PackMeshFile& mesh : meshes) writeMesh(json, mesh);
    json.close();
}

/// Sets the gap between the fragments of a body (kNone: of the whole), and what it takes from them.
void setGap(const Bake& bake, std::uint32_t fragment, PackBodySource& body) {
    const BakedFracture* fracture = bake.fractureOf(fragment);
    if (!fracture || fracture->fragments.gap == 0.0) return;
    double volume = 0.0;
    for (std::uint32_t k = 0; k < fracture->fragments.count(); ++k) volume += fracture->fragments[k].volume();
    body.gap = fracture->fragments.gap;
    body.lostVolume = std::max(0.0, body.mass.volume - volume);
}

PackBodySource sourceOfWhole(const Bake& bake, const Asset& asset) {
    PackBodySource whole{.id = std::to_string(asset.id),
                         .name = meshName(asset.name),
                         .offset = bake.whole.centre,
                         .mass = bake.whole,
                         .hulls = bake.wholeHulls};
    setGap(bake, kNone, whole);
    return whole;
}

/// Returns the fragments from `first` on, at most kChunk, as a JSON array.
std::string chunkJson(const Bake& bake, const Asset& asset, double density, std::size_t first) {
    std::vector<PackBodySource> bodies;
    const std::size_t end = std::min(first + kChunk, std::size_t{bake.fragmentCount()});
    bodies.reserve(end - first);
    for (auto k = static_cast<std::uint32_t>(first); k < end; ++k) {
        const BakedFragment fragment = bake.fragment(k);
        const Fragment& solid = fragment.solid;
        bodies.push_back({.id = bake.fragmentId(k),
                          .name = fragmentBodyName(asset, bake.fragmentId(k)),
                          .parent = fragment.parent,
                          .offset = solid.offset(),
                          .mass = solid.mass(),
                          .contacts = solid.contacts(),
                          .firstSibling = fragment.firstSibling,
                          .hulls = solid.hulls()});
        setGap(bake, k, bodies.back());
        if (fragment.childCount > 0) {
            bodies.back().threshold = fragmentThreshold(asset, pathOfId(bodies.back().id), fragment.level);
        }
    }
    std::size_t size = 0;
    for (const PackBodySource& body : bodies) size += packBodySize(body);
    JsonWriter json(JsonLayout::CompactLines, size);
    json.openArray();
    for (const PackBodySource& body : bodies) writePackBody(json, {}, body, density);
    json.close();
    return std::move(json).contents();
}

void addText(Hasher& hasher, std::string_view text) {
    hasher.add(std::uint64_t{text.size()});
    hasher.add(text);
}

/// Adds nothing where none is set, so that packs without any keep their hashes.
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

void addColour(Hasher& hasher, const Colour& colour) {
    for (const double value : {colour.red, colour.green, colour.blue}) hasher.add(value);
}

}  // namespace

std::string fragmentBodyName(const Asset& asset, std::string_view fragmentId) {
    std::string path = pathOfId(fragmentId);
    std::ranges::replace(path, '/', '-');
    std::ranges::replace(path, '+', '_');
    return meshName(asset.name) + '-' + path;
}

ContentHash packHash(const Asset& asset, const AssetMaterials& material, std::span<const PackMeshFile> meshes) {
    Hasher hasher;
    addText(hasher, kPackFormat.name);
    hasher.add(std::uint64_t{kPackVersion});
    addText(hasher, bakeInputHash(asset).hex());
    addText(hasher, asset.name);
    hasher.add(thresholdOf(asset, material.own));
    addFragmentThresholds(hasher, asset);
    addPackBonding(hasher, asset, material.own);
    addText(hasher, material.own.name);
    for (const double value : {material.own.density, material.own.friction, material.own.restitution})
        hasher.add(value);
    addColour(hasher, material.own.outside);
    addColour(hasher, material.inside.inside);
    for (const double opacity : {material.own.opacity, material.inside.opacity}) {
        if (opacity != 1.0) hasher.add(opacity);
    }
    for (const PackMeshFile& mesh : meshes) {
        addText(hasher, mesh.name);
        hasher.add(static_cast<std::uint64_t>(mesh.bodies));
        hasher.add(std::uint64_t{mesh.fragment});
        hasher.add(static_cast<std::uint64_t>(mesh.place));
    }
    return hasher.digest();
}

std::string packJson(const Bake& bake, const Asset& asset, const AssetMaterials& material,
                     std::span<const PackMeshFile> meshes, const TaskContext& task) {
    const PackBodySource whole = sourceOfWhole(bake, asset);
    std::vector<std::string> chunks((bake.fragmentCount() + kChunk - 1) / kChunk);
    forEachIndex(chunks.size(), task.threads,
                 [&](std::size_t k) { chunks[k] = chunkJson(bake, asset, material.own.density, kChunk * k); });

    std::size_t size = 4096 + packBodySize(whole) + 256 * meshes.size();
    for (const std::string& chunk : chunks) size += chunk.size();
    JsonWriter json(JsonLayout::CompactLines, size);
    json.openObject();
    writeHeader(json, bake, asset, material, meshes);
    writePackBody(json, "whole", whole, material.own.density);
    json.openArray("fragments", JsonLayout::CompactLines);
    for (const std::string& chunk : chunks) json.elements(chunk);
    json.close();
    writePackBonding(json, bake, asset, material.own);
    json.close();
    return withChecksum(std::move(json).finished());
}

}  // namespace rubble
