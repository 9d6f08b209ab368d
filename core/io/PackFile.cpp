#include "core/io/PackFile.h"

#include "core/asset/Threshold.h"
#include "core/base/Parallel.h"
#include "core/io/JsonText.h"
#include "core/io/NumberText.h"
#include "core/io/PackBodyJson.h"
#include "core/io/PackWords.h"

namespace rubble {
namespace {

constexpr std::size_t kChunk = 64;  // bodies that one thread writes in a row

void appendText(std::string& json, const char* key, std::string_view value) {
    json += key;
    appendJsonText(json, value);
}

void appendValue(std::string& json, const char* key, double value) {
    json += key;
    appendNumber(json, value);
}

void appendColour(std::string& json, const char* key, const Colour& colour) {
    appendValue(json, key, colour.red);
    appendValue(json, ",", colour.green);
    appendValue(json, ",", colour.blue);
    json += ']';
}

void appendMaterial(std::string& json, const AssetMaterials& material) {
    appendText(json, "\"material\":{\"name\":", material.own.name);
    appendValue(json, ",\"density\":", material.own.density);
    appendValue(json, ",\"friction\":", material.own.friction);
    appendValue(json, ",\"restitution\":", material.own.restitution);
    appendColour(json, ",\"outside\":[", material.own.outside);
    appendColour(json, ",\"inside\":[", material.inside.inside);
    json += "},\n";
}

void appendMeshes(std::string& json, std::span<const PackMeshFile> meshes) {
    json += "\"meshes\":[";
    for (const PackMeshFile& mesh : meshes) {
        appendText(json, &mesh == meshes.data() ? "\n{\"file\":" : ",\n{\"file\":", mesh.name);
        appendText(json, ",\"bodies\":", kMeshBodies[static_cast<std::size_t>(mesh.bodies)]);
        json += ",\"fragment\":" + (mesh.fragment == kNone ? "null" : std::to_string(mesh.fragment));
        appendText(json, ",\"place\":", kMeshPlaces[static_cast<std::size_t>(mesh.place)]);
        json += '}';
    }
    json += "],\n";
}

std::string headJson(const Asset& asset, const AssetMaterials& material, std::span<const PackMeshFile> meshes) {
    std::string json = "{\"format\":\"" + std::string(kPackFormat.name) + "\",\n\"version\":";
    appendNumber(json, kPackVersion);
    json += ",\n\"units\":{\"length\":\"m\",\"mass\":\"kg\",\"time\":\"s\"},\n";
    json += "\"axes\":{\"handedness\":\"right\",\"up\":\"y\",\"front\":\"counter-clockwise\"},\n\"asset\":{\"id\":";
    appendNumber(json, asset.id);
    appendText(json, ",\"name\":", asset.name);
    if (asset.shaping.gap > 0.0) appendValue(json, ",\"gap\":", asset.shaping.gap);
    json += "},\n\"hash\":\"" + packHash(asset, material, meshes).hex() + "\",\n";
    appendValue(json, "\"threshold\":", thresholdOf(asset, material.own));
    json += ",\n";
    appendMaterial(json, material);
    appendMeshes(json, meshes);
    return json;
}

BodySource sourceOfWhole(const Bake& bake, const Asset& asset) {
    return {.id = std::to_string(asset.id),
            .name = bodyName(asset),
            .offset = bake.whole.centre,
            .mass = bake.whole,
            .hulls = bake.wholeHulls};
}

TextBlock chunkJson(const Bake& bake, const Asset& asset, double density, std::size_t first) {
    std::vector<BodySource> bodies;
    const std::size_t end = std::min(first + kChunk, std::size_t{bake.fragmentCount()});
    bodies.reserve(end - first);
    for (auto k = static_cast<std::uint32_t>(first); k < end; ++k) {
        const BakedFragment fragment = bake.fragment(k);
        const Fragment& solid = fragment.solid;
        bodies.push_back({.id = bake.fragmentId(k),
                          .name = bodyName(asset, k),
                          .parent = fragment.parent,
                          .offset = solid.offset(),
                          .mass = solid.mass(),
                          .bonds = solid.bonds(),
                          .firstSibling = fragment.firstSibling,
                          .hulls = solid.hulls()});
    }
    return bodiesJson(bodies, density);
}

void addText(Hasher& hasher, std::string_view text) {
    hasher.add(std::uint64_t{text.size()});
    hasher.add(text);
}

void addColour(Hasher& hasher, const Colour& colour) {
    for (const double value : {colour.red, colour.green, colour.blue}) hasher.add(value);
}

}  // namespace

std::string bodyName(const Asset& asset, std::uint32_t fragment) {
    return meshName(asset.name) + (fragment == kNone ? "" : std::to_string(fragment));
}

ContentHash packHash(const Asset& asset, const AssetMaterials& material, std::span<const PackMeshFile> meshes) {
    Hasher hasher;
    addText(hasher, kPackFormat.name);
    hasher.add(std::uint64_t{kPackVersion});
    addText(hasher, bakeInputHash(asset).hex());
    addText(hasher, asset.name);
    hasher.add(thresholdOf(asset, material.own));
    addText(hasher, material.own.name);
    for (const double value : {material.own.density, material.own.friction, material.own.restitution})
        hasher.add(value);
    addColour(hasher, material.own.outside);
    addColour(hasher, material.inside.inside);
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
    const BodySource whole = sourceOfWhole(bake, asset);
    std::vector<TextBlock> chunks((bake.fragmentCount() + kChunk - 1) / kChunk);
    forEachIndex(chunks.size(), task.threads,
                 [&](std::size_t k) { chunks[k] = chunkJson(bake, asset, material.own.density, kChunk * k); });

    std::string json = headJson(asset, material, meshes);
    json += "\"whole\":";
    json += bodiesJson({&whole, 1}, material.own.density).view();
    json += ",\n\"fragments\":[";
    std::size_t size = json.size() + 8;
    for (const TextBlock& chunk : chunks) size += chunk.size + 2;
    json.reserve(size);
    for (const TextBlock& chunk : chunks) {
        json += &chunk == chunks.data() ? "\n" : ",\n";
        json += chunk.view();
    }
    json += "]}\n";
    return json;
}

}  // namespace rubble
