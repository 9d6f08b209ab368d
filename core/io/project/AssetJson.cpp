#include "core/io/project/AssetJson.h"

#include "core/base/MessageText.h"
#include "core/io/json/VectorJson.h"
#include "core/io/project/BondingJson.h"
#include "core/io/project/ColourJson.h"
#include "core/io/project/MeshFile.h"
#include "core/io/project/PatternJson.h"
#include "core/io/project/ShapingJson.h"
#include "core/io/project/StrengthRequirementJson.h"

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace rubble {
namespace {

constexpr std::array<std::string_view, 1> kStrengthRules{"bending"};  // by which thresholds are derived

void writePrism(JsonWriter& json, const Prism& prism) {
    json.openObject("prism");
    json.number("depth", prism.depth);
    writeOutline(json, prism.outline);
    json.close();
}

Prism readPrism(const JsonValue& value) {
    value.requireObject({"depth", "outline", "holes"});
    return {.outline = readOutline(value), .depth = value["depth"].number()};
}

void writeMembers(JsonWriter& json, const Level& level) {
    json.number("minimumVolume", level.minimumVolume);
    if (level.threshold) json.number("threshold", *level.threshold);
    writeBondStrength(json, level.bondStrength);
    writePattern(json, level.pattern);
}

void writeLevel(JsonWriter& json, const Level& level) {
    json.openObject();
    writeMembers(json, level);
    json.close();
}

Level readLevel(const JsonValue& value) {
    value.requireObject({"minimumVolume", "pattern"}, {"threshold", "bondStrength"});
    const JsonValue threshold = value["threshold"];
    return {.pattern = readPattern(value["pattern"]),
            .minimumVolume = value["minimumVolume"].number(),
            .threshold = threshold.isPresent() ? std::optional(threshold.number()) : std::nullopt,
            .bondStrength = readBondStrength(value)};
}

void writeFragmentThreshold(JsonWriter& json, const FragmentThreshold& own) {
    json.openObject({}, JsonLayout::Inline);
    json.text("fragment", own.fragment);
    json.number("threshold", own.threshold);
    json.close();
}

FragmentThreshold readFragmentThreshold(const JsonValue& value) {
    value.requireObject({"fragment", "threshold"});
    return {.fragment = value["fragment"].text(), .threshold = value["threshold"].number()};
}

void writeLeaf(JsonWriter& json, const FragmentLevel& leaf) {
    json.openObject();
    json.text("fragment", leaf.fragment);
    if (leaf.level) {
        json.openObject("level");
        writeMembers(json, *leaf.level);
        json.close();
    } else {
        json.null("level");
    }
    json.close();
}

FragmentLevel readLeaf(const JsonValue& value) {
    value.requireObject({"fragment", "level"});
    return {.fragment = value["fragment"].text(), .level = value["level"].optional(readLevel)};
}

void writeCap(JsonWriter& json, std::string_view key, const CapUv& cap) {
    json.openObject(key, JsonLayout::Inline);
    json.wholeNumber("material", cap.material);
    json.boolean("affine", cap.isAffine);
    json.numbers("map", cap.map.coefficients);
    json.close();
}

CapUv readCap(const JsonValue& value) {
    value.requireObject({"material", "affine", "map"});
    return {.isAffine = value["affine"].boolean(),
            .map = {value["map"].numbers<6>()},
            .material = value["material"].index()};
}

void writeTriangle(JsonWriter& json, const SurfaceTriangle& triangle) {
    json.openObject({}, JsonLayout::Inline);
    json.wholeNumber("material", triangle.material);
    json.openArray("corners", JsonLayout::Inline);
    for (const Vec3& corner : triangle.corners) writeVector(json, {}, corner);
    json.close();
    json.openArray("uvs", JsonLayout::Inline);
    for (const Vec2& uv : triangle.uvs) json.numbers({}, {uv.x, uv.y});
    json.close();
    json.close();
}

/// Reads an array of three arrays of numbers.
template <std::size_t Count, class Vector>
void readThree(const JsonValue& value, std::array<Vector, 3>& vectors) {
    if (value.elements().size() != 3) return value.fail("expected an array of 3 points");
    std::size_t k = 0;
    for (const JsonValue element : value.elements()) {
        const std::array<double, Count> numbers = element.numbers<Count>();
        for (std::size_t i = 0; i < Count; ++i) vectors[k][static_cast<int>(i)] = numbers[i];
        ++k;
    }
}

SurfaceTriangle readTriangle(const JsonValue& value) {
    value.requireObject({"material", "corners", "uvs"});
    SurfaceTriangle triangle{.corners = {}, .uvs = {}, .material = value["material"].index()};
    readThree<3>(value["corners"], triangle.corners);
    readThree<2>(value["uvs"], triangle.uvs);
    return triangle;
}

void writeSurface(JsonWriter& json, const Surface& surface) {
    json.openObject("surface");
    json.openArray("materials");
    for (const std::string& material : surface.materials) json.text({}, material);
    json.close();
    writeCap(json, "front", surface.front);
    writeCap(json, "back", surface.back);
    json.list("triangles", surface.triangles, writeTriangle);
    json.close();
}

std::shared_ptr<const Surface> readSurface(const JsonValue& value) {
    if (value.isNull()) return nullptr;
    value.requireObject({"materials", "front", "back", "triangles"});
    return std::make_shared<Surface>(Surface{.materials = value["materials"].list(&JsonValue::text),
                                             .front = readCap(value["front"]),
                                             .back = readCap(value["back"]),
                                             .triangles = value["triangles"].list(readTriangle)});
}

void writeMesh(JsonWriter& json, const ClosedMesh& mesh) {
    json.openObject("mesh", JsonLayout::Inline);
    json.text("hash", mesh.hash.hex());
    json.wholeNumber("points", mesh.mesh.points.size());
    json.wholeNumber("triangles", mesh.mesh.triangles.size());
    json.close();
}

/// What the file of a project says of a mesh.
struct MeshReference {
    ContentHash hash;
    std::size_t points = 0;
    std::size_t triangles = 0;
};

MeshReference readMeshReference(const JsonValue& value) {
    value.requireObject({"hash", "points", "triangles"});
    const std::optional<ContentHash> hash = parseContentHash(value["hash"].text());
    if (!hash) value["hash"].fail("expected a hash of 32 hexadecimal digits");
    return {.hash = hash.value_or(ContentHash()),
            .points = value["points"].wholeNumber(1, kMaxMeshFilePoints),
            .triangles = value["triangles"].wholeNumber(1, kMaxMeshFileTriangles)};
}

std::string countFault(std::size_t count) { return "the mesh of this hash has " + std::to_string(count); }

void writeShape(JsonWriter& json, const Asset& asset) {
    if (const ClosedMesh* mesh = asset.mesh())
        writeMesh(json, *mesh);
    else
        writePrism(json, asset.prism());
}

void writeProperties(JsonWriter& json, const Material& material) {
    json.wholeNumber("id", material.id);
    json.text("name", material.name);
    json.number("density", material.density);
    json.number("friction", material.friction);
    json.number("restitution", material.restitution);
}

void writeColours(JsonWriter& json, const Material& material) {
    writeColour(json, "outside", material.outside);
    writeColour(json, "inside", material.inside);
    writeOpacity(json, material.opacity);
}

Material readMaterialMembers1(const JsonValue& value) {
    return {.id = value["id"].index(),
            .name = value["name"].text(),
            .density = value["density"].number(),
            .friction = value["friction"].number(),
            .restitution = value["restitution"].number(),
            .outside = readColour(value["outside"]),
            .inside = readColour(value["inside"]),
            .opacity = readOpacity(value)};
}

Asset readAssetMembers1(const JsonValue& value) {
    const bool isPrism = !value["mesh"].isPresent();
    return {.id = value["id"].index(),
            .name = value["name"].text(),
            .material = value["material"].index(),
            .shape = isPrism ? readPrism(value["prism"]) : Prism(),
            .pattern = readPattern(value["pattern"]),
            .levels = value["levels"].list(readLevel),
            .threshold = value["threshold"].number(),
            .insideUvScale = value["insideUvScale"].number(),
            .surface = readSurface(value["surface"])};
}

Asset readAssetMembers2(const JsonValue& value) {
    Asset asset = readAssetMembers1(value);
    asset.cutAtImpact = value["cutAtImpact"].optional(readCutAtImpact);
    asset.requirements = value["intents"].list(readRequirement);
    return asset;
}

Asset readAssetMembers4(const JsonValue& value) {
    Asset asset = readAssetMembers2(value);
    const auto readId = [](const JsonValue& id) { return Id{id.index(1)}; };
    asset.insideMaterial = value["insideMaterial"].optional(readId).value_or(0);
    asset.shaping = readShaping(value["shaping"]);
    asset.fragmentLevels = value["leaves"].list(readLeaf);
    asset.edits = value["edits"].list(readEdit);
    return asset;
}

}  // namespace

void writeMaterial(JsonWriter& json, const Material& material) {
    json.openObject();
    writeProperties(json, material);
    json.number("tensileStrength", material.tensileStrength);
    json.number("fractureToughness", material.fractureToughness);
    if (material.youngsModulus) json.number("youngsModulus", *material.youngsModulus);
    writeColours(json, material);
    writeFinish(json, material.finish);
    json.close();
}

void writeMaterialBeforeVersion5(JsonWriter& json, const Material& material) {
    json.openObject();
    writeProperties(json, material);
    writeColours(json, material);
    json.close();
}

Material readMaterialBeforeVersion5(const JsonValue& value) {
    value.requireObject({"id", "name", "density", "friction", "restitution", "outside", "inside"}, {"opacity"});
    return readMaterialMembers1(value);
}

Material readMaterial(const JsonValue& value) {
    value.requireObject({"id", "name", "density", "friction", "restitution", "tensileStrength", "fractureToughness",
                         "outside", "inside"},
                        {"youngsModulus", "opacity", "finish"});
    Material material = readMaterialMembers1(value);
    material.tensileStrength = value["tensileStrength"].optionalNumber();
    material.fractureToughness = value["fractureToughness"].optionalNumber();
    if (value["youngsModulus"].isPresent()) material.youngsModulus = value["youngsModulus"].number();
    material.finish = readFinish(value);
    return material;
}

void writeAsset(JsonWriter& json, const Asset& asset, const ImageList& images) {
    json.openObject();
    json.wholeNumber("id", asset.id);
    json.text("name", asset.name);
    json.wholeNumber("material", asset.material);
    json.number("threshold", asset.threshold);
    json.number("contactTime", asset.contactTime);
    if (asset.contactTime) json.text("strengthRule", kStrengthRules[0]);
    json.number("insideUvScale", asset.insideUvScale);
    json.wholeNumber("insideMaterial", asset.insideMaterial == 0 ? std::nullopt : std::optional{asset.insideMaterial});
    writeShape(json, asset);
    writePattern(json, asset.pattern);
    writeShaping(json, asset.shaping);
    json.list("levels", asset.levels, writeLevel);
    json.list("leaves", asset.fragmentLevels, writeLeaf);
    if (!asset.fragmentThresholds.empty())
        json.list("fragmentThresholds", asset.fragmentThresholds, writeFragmentThreshold);
    json.list("edits", asset.edits, writeEdit);
    writeBonding(json, asset);
    writeCutAtImpact(json, asset.cutAtImpact);
    json.list("intents", asset.requirements, writeRequirement);
    if (asset.surface) {
        writeSurface(json, *asset.surface);
    } else {
        json.null("surface");
    }
    if (asset.texture) writeTexture(json, *asset.texture, images);
    json.close();
}

Asset readAssetVersion1(const JsonValue& value) {
    value.requireObject(
        {"id", "name", "material", "threshold", "insideUvScale", "prism", "pattern", "levels", "surface"});
    return readAssetMembers1(value);
}

Asset readAssetVersions2To3(const JsonValue& value) {
    value.requireObject({"id", "name", "material", "threshold", "insideUvScale", "prism", "pattern", "levels",
                         "cutAtImpact", "intents", "surface"});
    return readAssetMembers2(value);
}

Asset readAssetVersion4(const JsonValue& value) {
    value.requireObject({"id", "name", "material", "threshold", "insideUvScale", "insideMaterial", "prism", "pattern",
                         "shaping", "levels", "leaves", "edits", "cutAtImpact", "intents", "surface"});
    return readAssetMembers4(value);
}

Asset readAssetVersion5(const JsonValue& value) {
    if (value["mesh"].isPresent()) value.fail("unknown key \"mesh\"");
    return readAsset(value);
}

Asset readAsset(const JsonValue& value) {
    const bool isPrism = !value["mesh"].isPresent();
    value.requireObject({"id", "name", "material", "threshold", "contactTime", "insideUvScale", "insideMaterial",
                         isPrism ? "prism" : "mesh", "pattern", "shaping", "levels", "leaves", "edits", "cutAtImpact",
                         "intents", "surface"},
                        {"strengthRule", "fragmentThresholds", "breakAs", "bonding", "texture"});
    if (!isPrism) readMeshReference(value["mesh"]);  // its mesh is read later
    Asset asset = readAssetMembers4(value);
    asset.contactTime = value["contactTime"].optionalNumber();
    const JsonValue thresholds = value["fragmentThresholds"];
    if (thresholds.isPresent()) asset.fragmentThresholds = thresholds.list(readFragmentThreshold);
    readBonding(value, asset);
    const JsonValue rule = value["strengthRule"];
    if (rule.isPresent()) {
        rule.oneOf(kStrengthRules);
    } else if (asset.contactTime) {
        value.fail(
            "the threshold follows from the cross-section, which is no longer supported; add "
            "\"strengthRule\": \"bending\", or set \"contactTime\" to null");
    }
    return asset;
}

Status readMeshes(JsonDocument& document, std::vector<Asset>& assets, const MeshSource& meshes) {
    auto asset = assets.begin();
    for (const JsonValue value : document.root()["assets"].elements()) {
        Asset& reading = *asset++;
        if (!value["mesh"].isPresent()) continue;
        const MeshReference reference = readMeshReference(value["mesh"]);
        Result<std::shared_ptr<const ClosedMesh>> mesh =
            meshes ? meshes(reference.hash)
                   : Error{ErrorCode::Unsupported,
                           "Its mesh lies in a folder beside the project's file; give the file, not its text."};
        if (!mesh) return Error{mesh.error().code, "Asset " + quotedName(reading.name) + ": " + mesh.error().message};
        const TriangleMesh& read = (*mesh)->mesh;
        if (read.points.size() != reference.points) value["mesh"]["points"].fail(countFault(read.points.size()));
        if (read.triangles.size() != reference.triangles)
            value["mesh"]["triangles"].fail(countFault(read.triangles.size()));
        if (document.firstError()) return *document.firstError();
        reading.shape = std::move(*mesh);
    }
    return success();
}

}  // namespace rubble
