#include "core/io/pack/PackHeaderJson.h"

#include "core/base/Index.h"
#include "core/io/exchange/PackBuilder.h"
#include "core/io/pack/PackBondingJson.h"
#include "core/io/pack/PackFormat.h"
#include "core/io/project/ColourJson.h"

#include <algorithm>

namespace rubble {
namespace {

void writeAxes(JsonWriter& json) {
    json.openObject("axes");
    json.text("handedness", "right");
    json.text("up", "y");
    json.text("front", "counter-clockwise");
    json.close();
}

void writePackNames(JsonWriter& json, const Pack& pack) {
    json.openObject("asset");
    json.wholeNumber("id", std::uint64_t{pack.asset});
    json.text("name", pack.names.name);
    json.text("base", pack.names.base);
    json.wholeNumber("variant", std::uint64_t{pack.names.variant});
    json.text("folder", pack.names.folder);
    if (pack.gap > 0.0) json.number("gap", pack.gap);
    json.close();
}

void writePackBreak(JsonWriter& json, const Pack& pack) {
    json.openObject("break");
    json.text("as", kPackBreaks[static_cast<std::size_t>(pack.breaking.as)]);
    json.text("rule", kPackRules[static_cast<std::size_t>(pack.breaking.rule)]);
    json.text("velocity", kPackVelocity);
    json.number("leastSpeed", pack.breaking.leastSpeed);
    json.number("restitutionSpeed", pack.breaking.restitutionSpeed);
    if (pack.breaking.cutAtImpact) {
        json.openObject("cutAtImpact");
        json.wholeNumber("fragments", std::uint64_t{pack.breaking.cutAtImpact->fragments});
        json.number("falloffRadius", pack.breaking.cutAtImpact->falloffRadius);
        json.close();
    }
    json.close();
    json.openObject("combine");
    json.text("friction", kPackFrictionOfPair);
    json.text("restitution", kPackRestitutionOfPair);
    json.close();
    json.openObject("collision");
    json.number("inset", pack.inset);
    json.close();
}

void writePackMaterial(JsonWriter& json, const Material& material) {
    json.openObject();
    json.text("name", material.name);
    json.number("density", material.density);
    json.number("friction", material.friction);
    json.number("restitution", material.restitution);
    if (material.tensileStrength) json.number("tensileStrength", *material.tensileStrength);
    if (material.fractureToughness) json.number("fractureToughness", *material.fractureToughness);
    if (material.youngsModulus) json.number("youngsModulus", *material.youngsModulus);
    writeColour(json, "outside", material.outside);
    writeColour(json, "inside", material.inside);
    json.number("opacity", material.opacity);
    json.close();
}

void writePackSurface(JsonWriter& json, const PackSurface& surface) {
    json.openObject();
    json.text("name", surface.name);
    json.text("side", kPackSides[surface.isInside ? 1 : 0]);
    writeColour(json, "colour", surface.colour);
    json.number("opacity", surface.opacity);
    json.number("roughness", surface.roughness);
    if (!surface.texture.empty()) json.text("texture", surface.texture);
    json.close();
}

void writePackMaterials(JsonWriter& json, const Pack& pack) {
    json.openArray("materials", JsonLayout::CompactLines);
    for (const Material& material : pack.materials) writePackMaterial(json, material);
    json.close();
    json.wholeNumber("material", std::uint64_t{pack.material});
    json.wholeNumber("insideMaterial", std::uint64_t{pack.insideMaterial});
    json.openArray("surfaces", JsonLayout::CompactLines);
    for (const PackSurface& surface : pack.surfaces) writePackSurface(json, surface);
    json.close();
}

void writePackDebris(JsonWriter& json, const Debris& debris) {
    json.openObject("debris");
    if (debris.lifetime) json.number("lifetime", *debris.lifetime);
    json.number("fade", debris.fade);
    if (debris.maxFragments) json.wholeNumber("maxFragments", std::uint64_t{*debris.maxFragments});
    json.close();
}

void writeMesh(JsonWriter& json, const PackMeshFile& mesh) {
    json.openObject();
    json.text("file", mesh.name);
    json.text("bodies", kMeshBodies[static_cast<std::size_t>(mesh.bodies)]);
    json.wholeNumber("fragment", mesh.fragment == kNone ? std::nullopt : std::optional{mesh.fragment});
    json.text("place", kMeshPlaces[static_cast<std::size_t>(mesh.place)]);
    if (mesh.bodies == PackMeshBodies::Fragments) json.wholeNumber("level", mesh.level);
    json.close();
}

/// Reads an index; null becomes kNone.
std::uint32_t readFragment(const JsonValue& value) { return value.isNull() ? kNone : value.index(0, kNone - 1); }

Colour readUnitColour(const JsonValue& value) {
    const auto [red, green, blue] = value.numbers<3>(between(0.0, 1.0));
    return {red, green, blue};
}

Material readPackMaterial(const JsonValue& value) {
    value.requireKeys({"name", "density", "friction", "restitution", "outside", "inside"});
    const auto positive = [&](std::string_view key) {
        const JsonValue number = value[key];
        return number.isPresent() ? std::optional(number.number(above(0.0))) : std::nullopt;
    };
    const JsonValue opacity = value["opacity"];
    return {.name = value["name"].text(),
            .density = value["density"].number(above(0.0)),
            .friction = value["friction"].number(atLeast(0.0)),
            .restitution = value["restitution"].number(between(0.0, 1.0)),
            .tensileStrength = positive("tensileStrength"),
            .fractureToughness = positive("fractureToughness"),
            .youngsModulus = positive("youngsModulus"),
            .outside = readUnitColour(value["outside"]),
            .inside = readUnitColour(value["inside"]),
            .opacity = opacity.isPresent() ? opacity.number(between(0.0, 1.0)) : 1.0};
}

PackSurface readSurface(const JsonValue& value) {
    value.requireKeys({"name", "side", "colour", "opacity", "roughness"});
    const JsonValue texture = value["texture"];
    return {.name = value["name"].text(),
            .isInside = value["side"].oneOf(kPackSides) == 1,
            .colour = readUnitColour(value["colour"]),
            .opacity = value["opacity"].number(between(0.0, 1.0)),
            .roughness = value["roughness"].number(between(0.0, 1.0)),
            .texture = texture.isPresent() ? texture.text() : std::string()};
}

PackMeshFile readMesh(const JsonValue& value) {
    value.requireKeys({"file", "bodies", "fragment", "place"});
    const JsonValue level = value["level"];
    PackMeshFile mesh{.name = value["file"].text(),
                      .bodies = static_cast<PackMeshBodies>(value["bodies"].oneOf(kMeshBodies)),
                      .fragment = readFragment(value["fragment"]),
                      .place = static_cast<PartPlacement>(value["place"].oneOf(kMeshPlaces))};
    if (level.isPresent() && !level.isNull()) mesh.level = level.index();
    return mesh;
}

/// Requires that the values of keys are the only words that this version supports.
void requireWords(const JsonValue& value, std::initializer_list<std::array<std::string_view, 2>> words) {
    for (const auto& [key, word] : words) {
        if (value[key].isPresent()) value[key].oneOf(std::array{word});
    }
}

/// Reads what is in headers of all versions.
Pack readAnyHeader(const JsonValue& root) {
    root.requireKeys({"format", "version", "units", "axes", "asset", "hash", "threshold", "material", "meshes"});
    const JsonValue checksum = root["checksum"], asset = root["asset"];
    root["units"].requireKeys({"length", "mass", "time"});
    requireWords(root["units"], {{"length", "m"}, {"mass", "kg"}, {"time", "s"}});
    root["axes"].requireKeys({"handedness", "up", "front"});
    requireWords(root["axes"], {{"handedness", "right"}, {"up", "y"}, {"front", "counter-clockwise"}});
    asset.requireKeys({"id", "name"});
    const JsonValue gap = asset["gap"];
    Pack pack;
    if (root["generator"].isPresent()) pack.generator = root["generator"].text();
    pack.asset = asset["id"].index();
    pack.names.name = asset["name"].text();
    pack.gap = gap.isPresent() ? gap.number(above(0.0)) : 0.0;
    pack.hash = root["hash"].text();
    pack.checksum = checksum.isPresent() ? checksum.text() : std::string();
    pack.threshold = root["threshold"].number(above(0.0));
    pack.meshes = root["meshes"].list(readMesh);
    return pack;
}

PackBreak readPackBreak(const JsonValue& value) {
    value.requireKeys({"as", "rule", "velocity", "leastSpeed", "restitutionSpeed"});
    requireWords(value, {{"velocity", kPackVelocity}});
    PackBreak breaking{.as = static_cast<BreakAs>(value["as"].oneOf(kPackBreaks)),
                       .rule = static_cast<DamageRule>(value["rule"].oneOf(kPackRules)),
                       .leastSpeed = value["leastSpeed"].number(atLeast(0.0)),
                       .restitutionSpeed = value["restitutionSpeed"].number(atLeast(0.0))};
    const JsonValue cut = value["cutAtImpact"];
    if (!cut.isPresent()) return breaking;
    cut.requireKeys({"fragments", "falloffRadius"});
    breaking.cutAtImpact = {cut["fragments"].index(CutAtImpact::kMinFragments, CutAtImpact::kMaxFragments),
                            cut["falloffRadius"].number(above(0.0))};
    return breaking;
}

Debris readPackDebris(const JsonValue& value) {
    value.requireKeys({"fade"});
    const JsonValue lifetime = value["lifetime"], maxFragments = value["maxFragments"];
    Debris debris{.fade = value["fade"].number(atLeast(0.0))};
    if (lifetime.isPresent()) debris.lifetime = lifetime.number(above(0.0));
    if (maxFragments.isPresent()) debris.maxFragments = maxFragments.index(1);
    return debris;
}

/// Reads what version 2 added.
void readVersion2(const JsonValue& root, Pack& pack) {
    root.requireKeys({"physicsHash", "break", "combine", "collision", "materials", "insideMaterial", "surfaces"});
    const JsonValue asset = root["asset"], debris = root["debris"];
    asset.requireKeys({"base", "variant", "folder"});
    root["combine"].requireKeys({"friction", "restitution"});
    requireWords(root["combine"], {{"friction", kPackFrictionOfPair}, {"restitution", kPackRestitutionOfPair}});
    root["collision"].requireKeys({"inset"});
    pack.names.base = asset["base"].text();
    pack.names.variant = asset["variant"].index();
    pack.names.folder = asset["folder"].text();
    pack.physicsHash = root["physicsHash"].text();
    pack.breaking = readPackBreak(root["break"]);
    pack.inset = root["collision"]["inset"].number(atLeast(0.0));
    pack.materials = root["materials"].list(readPackMaterial);
    if (pack.materials.empty()) root["materials"].fail("expected a material at least");
    const std::uint32_t last = static_cast<std::uint32_t>(std::max<std::size_t>(1, pack.materials.size())) - 1;
    pack.material = root["material"].index(0, last);
    pack.insideMaterial = root["insideMaterial"].index(0, last);
    pack.surfaces = root["surfaces"].list(readSurface);
    if (debris.isPresent()) pack.debris = readPackDebris(debris);
}

}  // namespace

void writeUnits(JsonWriter& json) {
    json.openObject("units");
    json.text("length", "m");
    json.text("mass", "kg");
    json.text("time", "s");
    json.close();
}

void writePackHeader(JsonWriter& json, const Pack& pack) {
    json.text("format", kPackFormat.name);
    json.wholeNumber("version", std::uint64_t{kPackVersion});
    json.text("generator", pack.generator);
    writeUnits(json);
    writeAxes(json);
    writePackNames(json, pack);
    json.text("hash", pack.hash);
    json.text("physicsHash", pack.physicsHash);
    json.text("checksum", kNoChecksum);
    json.number("threshold", pack.threshold);
    writePackBreak(json, pack);
    writePackMaterials(json, pack);
    if (pack.debris) writePackDebris(json, *pack.debris);
    json.openArray("meshes", JsonLayout::CompactLines);
    for (const PackMeshFile& mesh : pack.meshes) writeMesh(json, mesh);
    json.close();
}

std::string packHeaderJson(const Pack& pack) {
    JsonWriter json(JsonLayout::Compact);
    json.openObject();
    writePackHeader(json, pack);
    if (pack.bonding) {
        PackBonding rule = *pack.bonding;
        rule.fractures.clear();
        writePackBonding(json, rule);
    }
    json.close();
    return std::move(json).contents();
}

Pack readPackHeader(const JsonValue& root, std::uint32_t version) {
    Pack pack = readAnyHeader(root);
    pack.version = version;
    const JsonValue bonding = root["bonding"];
    if (bonding.isPresent()) pack.bonding = readPackBonding(bonding);
    if (version >= 2) {
        readVersion2(root, pack);
        return pack;
    }
    pack.names = packNames({.id = pack.asset, .name = pack.names.name});
    pack.materials = {readPackMaterial(root["material"])};
    pack.breaking.as = pack.bonding ? BreakAs::Bonded : BreakAs::Whole;
    return pack;
}

}  // namespace rubble
