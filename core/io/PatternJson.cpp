#include "core/io/PatternJson.h"

#include <array>

namespace rubble {
namespace {

// In the order of their enumerators and of the alternatives of LayerParameters.
constexpr std::array<std::string_view, 2> kDomains{"outline", "boundingBox"};
constexpr std::array<std::string_view, 4> kKinds{"uniform", "blueNoise", "placed", "lloyd"};
static_assert(kKinds.size() == std::variant_size_v<LayerParameters>);

void writeDomain(JsonLayout& json, ScatterDomain domain) {
    json.text("domain", kDomains[static_cast<std::size_t>(domain)]);
}

ScatterDomain readDomain(const JsonValue& domain) { return static_cast<ScatterDomain>(domain.oneOf(kDomains)); }

Vec2 readPoint(const JsonValue& point) {
    const auto [x, y] = point.numbers<2>();
    return {x, y};
}

void writeParameters(JsonLayout& json, const UniformScatter& scatter) {
    json.wholeNumber("count", scatter.count);
    writeDomain(json, scatter.domain);
}

UniformScatter readUniform(const JsonValue& value) {
    value.requireObject({"count", "domain"});
    return {.count = value["count"].index(), .domain = readDomain(value["domain"])};
}

void writeParameters(JsonLayout& json, const BlueNoise& noise) {
    json.number("minimumDistance", noise.minimumDistance);
    json.wholeNumber("count", noise.count);
    writeDomain(json, noise.domain);
}

BlueNoise readBlueNoise(const JsonValue& value) {
    value.requireObject({"minimumDistance", "count", "domain"});
    return {.minimumDistance = value["minimumDistance"].number(),
            .count = value["count"].index(),
            .domain = readDomain(value["domain"])};
}

void writeParameters(JsonLayout& json, const PlacedSeeds& placed) {
    json.openArray("seeds");
    for (const PlacedSeeds::Seed& seed : placed.seeds) {
        json.openObject({}, JsonLines::One);
        json.wholeNumber("index", seed.index);
        json.numbers("position", {seed.position.x, seed.position.y});
        json.close();
    }
    json.close();
}

PlacedSeeds readPlaced(const JsonValue& value) {
    value.requireObject({"seeds"});
    PlacedSeeds placed;
    for (const JsonValue seed : value["seeds"].elements()) {
        seed.requireObject({"index", "position"});
        placed.seeds.push_back({.index = seed["index"].index(), .position = readPoint(seed["position"])});
    }
    return placed;
}

void writeParameters(JsonLayout& json, const LloydRelaxation& relaxation) {
    json.wholeNumber("rounds", relaxation.rounds);
}

LloydRelaxation readLloyd(const JsonValue& value) {
    value.requireObject({"rounds"});
    return {.rounds = value["rounds"].index()};
}

LayerParameters readParameters(std::size_t kind, const JsonValue& value) {
    switch (kind) {
        case 0: return readUniform(value);
        case 1: return readBlueNoise(value);
        case 2: return readPlaced(value);
        default: return readLloyd(value);
    }
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
            .position = readPoint(value["position"])};
}

void writeLayer(JsonLayout& json, const PatternLayer& layer) {
    json.openObject();
    json.wholeNumber("id", layer.id);
    json.boolean("on", layer.isOn);
    json.wholeNumber("randomSeed", layer.randomSeed);
    json.text("kind", kKinds[layer.parameters.index()]);
    json.openObject("parameters");
    std::visit([&](const auto& parameters) { writeParameters(json, parameters); }, layer.parameters);
    json.close();
    json.openArray("overrides");
    for (const SeedOverride& change : layer.overrides) writeOverride(json, change);
    json.close();
    json.close();
}

PatternLayer readLayer(const JsonValue& value) {
    value.requireObject({"id", "on", "randomSeed", "kind", "parameters", "overrides"});
    PatternLayer layer{.id = value["id"].index(),
                       .isOn = value["on"].boolean(),
                       .randomSeed = value["randomSeed"].wholeNumber(),
                       .parameters = readParameters(value["kind"].oneOf(kKinds), value["parameters"])};
    for (const JsonValue change : value["overrides"].elements()) layer.overrides.push_back(readOverride(change));
    return layer;
}

}  // namespace

void writePattern(JsonLayout& json, const Pattern& pattern) {
    json.openArray("pattern");
    for (const PatternLayer& layer : pattern.layers) writeLayer(json, layer);
    json.close();
}

Pattern readPattern(const JsonValue& layers) {
    Pattern pattern;
    for (const JsonValue layer : layers.elements()) pattern.layers.push_back(readLayer(layer));
    return pattern;
}

std::vector<Vec2> readPoints(const JsonValue& points) {
    std::vector<Vec2> read;
    for (const JsonValue point : points.elements()) read.push_back(readPoint(point));
    return read;
}

}  // namespace rubble
