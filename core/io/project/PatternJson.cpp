#include "core/io/project/PatternJson.h"

#include "core/fracture/pattern/PatternKind.h"
#include "core/io/project/GreyImageJson.h"

#include <vector>

namespace rubble {
namespace {

constexpr std::string_view kPerSquareMetre = "perSquareMetre";
constexpr std::string_view kPieceSize = "pieceSize";

/// The names of the kinds in files, in the order of LayerParameters.
std::vector<std::string_view> kindNames() {
    std::vector<std::string_view> names;
    for (const PatternKind* kind : patternKinds()) names.push_back(kind->name);
    return names;
}

std::vector<std::string_view> namesOf(std::span<const ParameterOption> options) {
    std::vector<std::string_view> names;
    for (const ParameterOption& option : options) names.push_back(option.name);
    return names;
}

/// Writes a number of seeds as a number; a density or a piece size as an object with its key.
void writeCount(JsonWriter& json, std::string_view key, const SeedCount& count) {
    if (count.by == CountBy::Number) return json.wholeNumber(key, static_cast<std::uint32_t>(count.amount));
    json.openObject(key, JsonLayout::Inline);
    json.number(count.by == CountBy::Density ? kPerSquareMetre : kPieceSize, count.amount);
    json.close();
}

SeedCount readCount(const JsonValue& value) {
    if (!value.isObject()) return value.index();
    if (value[kPieceSize].isPresent()) {
        value.requireObject({kPieceSize});
        return {CountBy::FragmentSize, value[kPieceSize].number()};
    }
    value.requireObject({kPerSquareMetre});
    return {CountBy::Density, value[kPerSquareMetre].number()};
}

void writeParameter(JsonWriter& json, const LayerParameter& parameter, const LayerParameters& of) {
    const ParameterValue value = parameter.read(of);
    const auto whole = [&] { return static_cast<std::uint32_t>(std::get<double>(value)); };
    switch (parameter.type) {
        case ParameterType::Whole: return json.wholeNumber(parameter.name, whole());
        case ParameterType::Real: return json.number(parameter.name, std::get<double>(value));
        case ParameterType::Option: return json.text(parameter.name, parameter.options[whole()].name);
        case ParameterType::Count: return writeCount(json, parameter.name, std::get<SeedCount>(value));
        case ParameterType::Point: {
            const Vec2 point = std::get<Vec2>(value);
            return json.numbers(parameter.name, {point.x, point.y});
        }
    }
}

ParameterValue readParameter(const JsonValue& value, const LayerParameter& parameter) {
    switch (parameter.type) {
        case ParameterType::Whole: return static_cast<double>(value.index());
        case ParameterType::Option: return static_cast<double>(value.oneOf(namesOf(parameter.options)));
        case ParameterType::Point: return value.point();
        case ParameterType::Count: return readCount(value);
        case ParameterType::Real: break;
    }
    return value.number();
}

/// Writes the height of a seed in space, unless it is zero.
void writeHeight(JsonWriter& json, double height) {
    if (height != 0.0) json.number("height", height);
}
double readHeight(const JsonValue& object) { return object["height"].isPresent() ? object["height"].number() : 0.0; }

void writeSeed(JsonWriter& json, const PlacedSeeds::Seed& seed) {
    json.openObject({}, JsonLayout::Inline);
    json.wholeNumber("index", seed.index);
    json.numbers("position", {seed.position.x, seed.position.y});
    writeHeight(json, seed.height);
    json.close();
}

PlacedSeeds::Seed readSeed(const JsonValue& value) {
    value.requireObject({"index", "position"}, {"height"});
    return {.index = value["index"].index(), .position = value["position"].point(), .height = readHeight(value)};
}

// Data that a kind has besides its parameters: its key, and how it is written and read.
template <class Parameters>
std::string_view dataKey(const Parameters&) {
    return {};
}
template <class Parameters>
void writeData(JsonWriter&, const Parameters&) {}
template <class Parameters>
void readData(const JsonValue&, Parameters&) {}

std::string_view dataKey(const PlacedSeeds&) { return "seeds"; }
void writeData(JsonWriter& json, const PlacedSeeds& placed) { json.list("seeds", placed.seeds, writeSeed); }
void readData(const JsonValue& value, PlacedSeeds& placed) { placed.seeds = value.list(readSeed); }

void writeCrackLine(JsonWriter& json, const CrackLines::CrackLine& line) {
    json.openObject();
    json.wholeNumber("index", line.index);
    json.points("points", line.points);
    json.close();
}

CrackLines::CrackLine readCrackLine(const JsonValue& value) {
    value.requireObject({"index", "points"});
    return {.index = value["index"].index(), .points = value["points"].points()};
}

std::string_view dataKey(const CrackLines&) { return "strokes"; }
void writeData(JsonWriter& json, const CrackLines& layer) { json.list("strokes", layer.lines, writeCrackLine); }
void readData(const JsonValue& value, CrackLines& layer) { layer.lines = value.list(readCrackLine); }

std::string_view dataKey(const DensityImage&) { return "image"; }
void writeData(JsonWriter& json, const DensityImage& layer) { writeGreyImage(json, "image", layer.image.get()); }
void readData(const JsonValue& value, DensityImage& layer) { layer.image = readGreyImage(value); }

void writeParameters(JsonWriter& json, const LayerParameters& parameters) {
    for (const LayerParameter& each : kindOf(parameters).parameters) {
        if (isWritten(each, parameters)) writeParameter(json, each, parameters);
    }
    std::visit([&](const auto& kind) { writeData(json, kind); }, parameters);
}

LayerParameters readParameters(const PatternKind& kind, const JsonValue& value) {
    LayerParameters read = kind.defaultsFor({{0.0, 0.0}, {1.0, 1.0}});  // all but spatial values are overwritten
    const std::string_view data = std::visit([](const auto& parameters) { return dataKey(parameters); }, read);
    std::vector<std::string_view> keys, spatialKeys;
    for (const LayerParameter& parameter : kind.parameters)
        (parameter.isSpatial ? spatialKeys : keys).push_back(parameter.name);
    if (!data.empty()) keys.push_back(data);
    value.requireObject(keys, spatialKeys);
    for (const LayerParameter& each : kind.parameters) {
        const JsonValue given = value[each.name];
        if (!each.isSpatial || given.isPresent()) each.write(read, readParameter(given, each));
    }
    if (!data.empty()) std::visit([&](auto& parameters) { readData(value[data], parameters); }, read);
    return read;
}

void writeOverride(JsonWriter& json, const SeedOverride& change) {
    json.openObject({}, JsonLayout::Inline);
    json.wholeNumber("index", change.index);
    json.boolean("deleted", change.isDeleted);
    json.numbers("position", {change.position.x, change.position.y});
    writeHeight(json, change.height);
    json.close();
}

SeedOverride readOverride(const JsonValue& value) {
    value.requireObject({"index", "deleted", "position"}, {"height"});
    return {.index = value["index"].index(),
            .isDeleted = value["deleted"].boolean(),
            .position = value["position"].point(),
            .height = readHeight(value)};
}

void writeLayer(JsonWriter& json, const PatternLayer& layer) {
    json.openObject();
    json.wholeNumber("id", layer.id);
    json.boolean("on", layer.isOn);
    json.wholeNumber("randomSeed", layer.randomSeed);
    json.text("kind", kindOf(layer.parameters).name);
    json.openObject("parameters");
    writeParameters(json, layer.parameters);
    json.close();
    json.list("overrides", layer.overrides, writeOverride);
    if (layer.scatteredIn) {
        json.openObject("scatteredIn");
        writeOutline(json, *layer.scatteredIn);
        json.close();
    }
    json.close();
}

Polygon readScatteredIn(const JsonValue& value) {
    value.requireObject({"outline", "holes"});
    return readOutline(value);
}

PatternLayer readLayer(const JsonValue& value) {
    value.requireObject({"id", "on", "randomSeed", "kind", "parameters", "overrides"}, {"scatteredIn"});
    return {.id = value["id"].index(),
            .isOn = value["on"].boolean(),
            .randomSeed = value["randomSeed"].wholeNumber(),
            .parameters = readParameters(*patternKinds()[value["kind"].oneOf(kindNames())], value["parameters"]),
            .overrides = value["overrides"].list(readOverride),
            .scatteredIn =
                value["scatteredIn"].isPresent() ? std::optional(readScatteredIn(value["scatteredIn"])) : std::nullopt};
}

}  // namespace

void writeOutline(JsonWriter& json, const Polygon& outline) {
    json.points("outline", outline.outer);
    json.openArray("holes");
    for (const Ring& hole : outline.holes) json.points({}, hole);
    json.close();
}

Polygon readOutline(const JsonValue& object) {
    return {object["outline"].points(), object["holes"].list(&JsonValue::points)};
}

void writePattern(JsonWriter& json, const Pattern& pattern) { json.list("pattern", pattern.layers, writeLayer); }

Pattern readPattern(const JsonValue& layers) { return {.layers = layers.list(readLayer)}; }

}  // namespace rubble
