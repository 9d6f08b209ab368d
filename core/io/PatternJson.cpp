#include "core/io/PatternJson.h"

#include "core/fracture/PatternKind.h"
#include "core/io/GreyImageJson.h"

#include <vector>

namespace rubble {
namespace {

constexpr std::string_view kPerSquareMetre = "perSquareMetre";
constexpr std::string_view kPieceSize = "pieceSize";

/// What files call the kinds, in the order of LayerParameters.
std::vector<std::string_view> kindNames() {
    std::vector<std::string_view> names;
    for (const PatternKind* kind : patternKinds()) names.push_back(kind->name);
    return names;
}

std::vector<std::string_view> namesOf(std::span<const ParameterChoice> choices) {
    std::vector<std::string_view> names;
    for (const ParameterChoice& choice : choices) names.push_back(choice.name);
    return names;
}

/// A count by number stands there as it is; another one in an object that names by what.
void writeCount(JsonLayout& json, std::string_view key, const SeedCount& count) {
    if (count.by == CountBy::Number) return json.wholeNumber(key, static_cast<std::uint32_t>(count.amount));
    json.openObject(key, JsonLines::One);
    json.number(count.by == CountBy::Density ? kPerSquareMetre : kPieceSize, count.amount);
    json.close();
}

SeedCount readCount(const JsonValue& value) {
    if (!value.isObject()) return value.index();
    if (value[kPieceSize].isPresent()) {
        value.requireObject({kPieceSize});
        return {CountBy::PieceSize, value[kPieceSize].number()};
    }
    value.requireObject({kPerSquareMetre});
    return {CountBy::Density, value[kPerSquareMetre].number()};
}

void writeParameter(JsonLayout& json, const LayerParameter& parameter, const LayerParameters& of) {
    const ParameterValue value = parameter.read(of);
    const auto whole = [&] { return static_cast<std::uint32_t>(std::get<double>(value)); };
    switch (parameter.type) {
        case ParameterType::Whole: return json.wholeNumber(parameter.name, whole());
        case ParameterType::Real: return json.number(parameter.name, std::get<double>(value));
        case ParameterType::Choice: return json.text(parameter.name, parameter.choices[whole()].name);
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
        case ParameterType::Choice: return static_cast<double>(value.oneOf(namesOf(parameter.choices)));
        case ParameterType::Point: return value.point();
        case ParameterType::Count: return readCount(value);
        case ParameterType::Real: break;
    }
    return value.number();
}

void writeSeed(JsonLayout& json, const PlacedSeeds::Seed& seed) {
    json.openObject({}, JsonLines::One);
    json.wholeNumber("index", seed.index);
    json.numbers("position", {seed.position.x, seed.position.y});
    json.close();
}

PlacedSeeds::Seed readSeed(const JsonValue& value) {
    value.requireObject({"index", "position"});
    return {.index = value["index"].index(), .position = value["position"].point()};
}

// What a kind holds besides its parameters: the key it stands at, if there is any, and how it is written and read.
template <class Parameters>
std::string_view heldKey(const Parameters&) {
    return {};
}
template <class Parameters>
void writeHeld(JsonLayout&, const Parameters&) {}
template <class Parameters>
void readHeld(const JsonValue&, Parameters&) {}

std::string_view heldKey(const PlacedSeeds&) { return "seeds"; }
void writeHeld(JsonLayout& json, const PlacedSeeds& placed) { json.list("seeds", placed.seeds, writeSeed); }
void readHeld(const JsonValue& value, PlacedSeeds& placed) { placed.seeds = value.listOf(readSeed); }

void writeStroke(JsonLayout& json, const Strokes::Stroke& stroke) {
    json.openObject();
    json.wholeNumber("index", stroke.index);
    json.points("points", stroke.points);
    json.close();
}

Strokes::Stroke readStroke(const JsonValue& value) {
    value.requireObject({"index", "points"});
    return {.index = value["index"].index(), .points = value["points"].points()};
}

std::string_view heldKey(const Strokes&) { return "strokes"; }
void writeHeld(JsonLayout& json, const Strokes& layer) { json.list("strokes", layer.strokes, writeStroke); }
void readHeld(const JsonValue& value, Strokes& layer) { layer.strokes = value.listOf(readStroke); }

std::string_view heldKey(const DensityImage&) { return "image"; }
void writeHeld(JsonLayout& json, const DensityImage& layer) { writeGreyImage(json, "image", layer.image.get()); }
void readHeld(const JsonValue& value, DensityImage& layer) { layer.image = readGreyImage(value); }

void writeParameters(JsonLayout& json, const LayerParameters& parameters) {
    for (const LayerParameter& each : kindOf(parameters).parameters) writeParameter(json, each, parameters);
    std::visit([&](const auto& kind) { writeHeld(json, kind); }, parameters);
}

LayerParameters readParameters(const PatternKind& kind, const JsonValue& value) {
    LayerParameters read = kind.suitedTo({{0.0, 0.0}, {1.0, 1.0}});  // all of it is overwritten
    const std::string_view held = std::visit([](const auto& parameters) { return heldKey(parameters); }, read);
    std::vector<std::string_view> keys;
    for (const LayerParameter& parameter : kind.parameters) keys.push_back(parameter.name);
    if (!held.empty()) keys.push_back(held);
    value.requireObject(keys);
    for (const LayerParameter& each : kind.parameters) each.write(read, readParameter(value[each.name], each));
    if (!held.empty()) std::visit([&](auto& parameters) { readHeld(value[held], parameters); }, read);
    return read;
}

void writeOverride(JsonLayout& json, const SeedOverride& change) {
    json.openObject({}, JsonLines::One);
    json.wholeNumber("index", change.index);
    json.boolean("deleted", change.isDeleted);
    json.numbers("position", {change.position.x, change.position.y});
    json.close();
}

SeedOverride readOverride(const JsonValue& value) {
    value.requireObject({"index", "deleted", "position"});
    return {.index = value["index"].index(),
            .isDeleted = value["deleted"].boolean(),
            .position = value["position"].point()};
}

void writeLayer(JsonLayout& json, const PatternLayer& layer) {
    json.openObject();
    json.wholeNumber("id", layer.id);
    json.boolean("on", layer.isOn);
    json.wholeNumber("randomSeed", layer.randomSeed);
    json.text("kind", kindOf(layer.parameters).name);
    json.openObject("parameters");
    writeParameters(json, layer.parameters);
    json.close();
    json.list("overrides", layer.overrides, writeOverride);
    json.close();
}

PatternLayer readLayer(const JsonValue& value) {
    value.requireObject({"id", "on", "randomSeed", "kind", "parameters", "overrides"});
    return {.id = value["id"].index(),
            .isOn = value["on"].boolean(),
            .randomSeed = value["randomSeed"].wholeNumber(),
            .parameters = readParameters(*patternKinds()[value["kind"].oneOf(kindNames())], value["parameters"]),
            .overrides = value["overrides"].listOf(readOverride)};
}

}  // namespace

void writePattern(JsonLayout& json, const Pattern& pattern) { json.list("pattern", pattern.layers, writeLayer); }

Pattern readPattern(const JsonValue& layers) { return {.layers = layers.listOf(readLayer)}; }

}  // namespace rubble
