#include "core/io/AssetJson.h"

#include "core/io/IntentJson.h"
#include "core/io/PatternJson.h"
#include "core/io/ShapingJson.h"

namespace rubble {
namespace {

void writePrism(JsonLayout& json, const Prism& prism) {
    json.openObject("prism");
    json.number("depth", prism.depth);
    json.points("outline", prism.outline.outer);
    json.openArray("holes");
    for (const Ring& hole : prism.outline.holes) json.points({}, hole);
    json.close();
    json.close();
}

Prism readPrism(const JsonValue& value) {
    value.requireObject({"depth", "outline", "holes"});
    return {.outline = {value["outline"].points(), value["holes"].listOf(&JsonValue::points)},
            .depth = value["depth"].number()};
}

void writeMembers(JsonLayout& json, const Level& level) {
    json.number("minimumVolume", level.minimumVolume);
    writePattern(json, level.pattern);
}

void writeLevel(JsonLayout& json, const Level& level) {
    json.openObject();
    writeMembers(json, level);
    json.close();
}

Level readLevel(const JsonValue& value) {
    value.requireObject({"minimumVolume", "pattern"});
    return {.pattern = readPattern(value["pattern"]), .minimumVolume = value["minimumVolume"].number()};
}

void writeLeaf(JsonLayout& json, const FragmentLevel& leaf) {
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
    return {.fragment = value["fragment"].text(), .level = value["level"].orNone(readLevel)};
}

void writeCap(JsonLayout& json, std::string_view key, const CapUv& cap) {
    json.openObject(key, JsonLines::One);
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

void writeTriangle(JsonLayout& json, const SurfaceTriangle& triangle) {
    json.openObject({}, JsonLines::One);
    json.wholeNumber("material", triangle.material);
    json.openArray("corners", JsonLines::One);
    for (const Vec3& corner : triangle.corners) json.numbers({}, {corner.x, corner.y, corner.z});
    json.close();
    json.openArray("uvs", JsonLines::One);
    for (const Vec2& uv : triangle.uvs) json.numbers({}, {uv.x, uv.y});
    json.close();
    json.close();
}

/// Reads an array of three arrays of numbers.
template <std::size_t Count, class Vector>
void readThree(const JsonValue& value, std::array<Vector, 3>& vectors) {
    if (value.elements().size() != 3) return value.refuse("expected an array of 3 points");
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

void writeSurface(JsonLayout& json, const Surface& surface) {
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
    return std::make_shared<Surface>(Surface{.materials = value["materials"].listOf(&JsonValue::text),
                                             .front = readCap(value["front"]),
                                             .back = readCap(value["back"]),
                                             .triangles = value["triangles"].listOf(readTriangle)});
}

void writeFigures(JsonLayout& json, const Material& material) {
    json.wholeNumber("id", material.id);
    json.text("name", material.name);
    json.number("density", material.density);
    json.number("friction", material.friction);
    json.number("restitution", material.restitution);
}

void writeColours(JsonLayout& json, const Material& material) {
    writeColour(json, "outside", material.outside);
    writeColour(json, "inside", material.inside);
}

Material readWhatVersion1KnewOfMaterials(const JsonValue& value) {
    return {.id = value["id"].index(),
            .name = value["name"].text(),
            .density = value["density"].number(),
            .friction = value["friction"].number(),
            .restitution = value["restitution"].number(),
            .outside = readColour(value["outside"]),
            .inside = readColour(value["inside"])};
}

Asset readWhatVersion1Knew(const JsonValue& value) {
    return {.id = value["id"].index(),
            .name = value["name"].text(),
            .material = value["material"].index(),
            .prism = readPrism(value["prism"]),
            .pattern = readPattern(value["pattern"]),
            .levels = value["levels"].listOf(readLevel),
            .threshold = value["threshold"].number(),
            .insideUvScale = value["insideUvScale"].number(),
            .surface = readSurface(value["surface"])};
}

Asset readWhatVersion2Knew(const JsonValue& value) {
    Asset asset = readWhatVersion1Knew(value);
    asset.cutAtImpact = value["cutAtImpact"].orNone(readCutAtImpact);
    asset.intents = value["intents"].listOf(readIntent);
    return asset;
}

Asset readWhatVersion4Knew(const JsonValue& value) {
    Asset asset = readWhatVersion2Knew(value);
    const auto readId = [](const JsonValue& id) { return Id{id.index(1)}; };
    asset.insideMaterial = value["insideMaterial"].orNone(readId).value_or(0);
    asset.shaping = readShaping(value["shaping"]);
    asset.leaves = value["leaves"].listOf(readLeaf);
    asset.edits = value["edits"].listOf(readEdit);
    return asset;
}

}  // namespace

void writeColour(JsonLayout& json, std::string_view key, const Colour& colour) {
    json.numbers(key, {colour.red, colour.green, colour.blue});
}

Colour readColour(const JsonValue& value) {
    const auto [red, green, blue] = value.numbers<3>();
    return {red, green, blue};
}

void writeMaterial(JsonLayout& json, const Material& material) {
    json.openObject();
    writeFigures(json, material);
    json.number("tensileStrength", material.tensileStrength);
    json.number("fractureToughness", material.fractureToughness);
    writeColours(json, material);
    json.close();
}

void writeMaterialVersion1(JsonLayout& json, const Material& material) {
    json.openObject();
    writeFigures(json, material);
    writeColours(json, material);
    json.close();
}

Material readMaterialVersion1(const JsonValue& value) {
    value.requireObject({"id", "name", "density", "friction", "restitution", "outside", "inside"});
    return readWhatVersion1KnewOfMaterials(value);
}

Material readMaterial(const JsonValue& value) {
    value.requireObject({"id", "name", "density", "friction", "restitution", "tensileStrength", "fractureToughness",
                         "outside", "inside"});
    Material material = readWhatVersion1KnewOfMaterials(value);
    material.tensileStrength = value["tensileStrength"].numberOrNone();
    material.fractureToughness = value["fractureToughness"].numberOrNone();
    return material;
}

void writeAsset(JsonLayout& json, const Asset& asset) {
    json.openObject();
    json.wholeNumber("id", asset.id);
    json.text("name", asset.name);
    json.wholeNumber("material", asset.material);
    json.number("threshold", asset.threshold);
    json.number("contactTime", asset.contactTime);
    json.number("insideUvScale", asset.insideUvScale);
    json.wholeNumber("insideMaterial", asset.insideMaterial == 0 ? std::nullopt : std::optional{asset.insideMaterial});
    writePrism(json, asset.prism);
    writePattern(json, asset.pattern);
    writeShaping(json, asset.shaping);
    json.list("levels", asset.levels, writeLevel);
    json.list("leaves", asset.leaves, writeLeaf);
    json.list("edits", asset.edits, writeEdit);
    writeCutAtImpact(json, asset.cutAtImpact);
    json.list("intents", asset.intents, writeIntent);
    if (asset.surface) {
        writeSurface(json, *asset.surface);
    } else {
        json.null("surface");
    }
    json.close();
}

Asset readAssetVersion1(const JsonValue& value) {
    value.requireObject(
        {"id", "name", "material", "threshold", "insideUvScale", "prism", "pattern", "levels", "surface"});
    return readWhatVersion1Knew(value);
}

Asset readAssetVersion2(const JsonValue& value) {
    value.requireObject({"id", "name", "material", "threshold", "insideUvScale", "prism", "pattern", "levels",
                         "cutAtImpact", "intents", "surface"});
    return readWhatVersion2Knew(value);
}

Asset readAssetVersion4(const JsonValue& value) {
    value.requireObject({"id", "name", "material", "threshold", "insideUvScale", "insideMaterial", "prism", "pattern",
                         "shaping", "levels", "leaves", "edits", "cutAtImpact", "intents", "surface"});
    return readWhatVersion4Knew(value);
}

Asset readAsset(const JsonValue& value) {
    value.requireObject({"id", "name", "material", "threshold", "contactTime", "insideUvScale", "insideMaterial",
                         "prism", "pattern", "shaping", "levels", "leaves", "edits", "cutAtImpact", "intents",
                         "surface"});
    Asset asset = readWhatVersion4Knew(value);
    asset.contactTime = value["contactTime"].numberOrNone();
    return asset;
}

}  // namespace rubble
