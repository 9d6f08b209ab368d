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

void writeParameters(JsonLayout& json, const PlacedSeeds& placed) { json.list("seeds", placed.seeds, writeSeed); }

PlacedSeeds readPlaced(const JsonValue& value) {
    value.requireObject({"seeds"});
    return {.seeds = value["seeds"].listOf(readSeed)};
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
            .position = value["position"].point()};
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
    json.list("overrides", layer.overrides, writeOverride);
    json.close();
}

PatternLayer readLayer(const JsonValue& value) {
    value.requireObject({"id", "on", "randomSeed", "kind", "parameters", "overrides"});
    return {.id = value["id"].index(),
            .isOn = value["on"].boolean(),
            .randomSeed = value["randomSeed"].wholeNumber(),
            .parameters = readParameters(value["kind"].oneOf(kKinds), value["parameters"]),
            .overrides = value["overrides"].listOf(readOverride)};
}

}  // namespace

void writePattern(JsonLayout& json, const Pattern& pattern) { json.list("pattern", pattern.layers, writeLayer); }

Pattern readPattern(const JsonValue& layers) { return {.layers = layers.listOf(readLayer)}; }

}  // namespace rubble
