#include "core/io/pack/PackBondingJson.h"

#include "core/io/json/VectorJson.h"
#include "core/io/pack/PackFormat.h"
#include "core/structure/clusters/ClusterLevels.h"

namespace rubble {
namespace {

void writePackBond(JsonWriter& json, const PackBond& bond) {
    json.openObject();
    json.wholeNumbers("fragments", bond.fragments);
    json.number("area", bond.area);
    writeVector(json, "centroid", bond.centroid);
    writeVector(json, "normal", bond.normal);
    json.number("capacity", bond.capacity);
    if (bond.clusterLevel > 0) json.wholeNumber("clusterLevel", std::uint64_t{bond.clusterLevel});
    json.close();
}

void writePackFracture(JsonWriter& json, const PackFracture& fracture) {
    json.openObject();
    json.wholeNumber("fragment", fracture.fragment == kNone ? std::nullopt : std::optional{fracture.fragment});
    json.openArray("bonds");
    for (const PackBond& bond : fracture.bonds) writePackBond(json, bond);
    json.close();
    json.close();
}

PackBond readPackBond(const JsonValue& value) {
    value.requireKeys({"fragments", "area", "centroid", "normal", "capacity"});
    const auto pair = value["fragments"].list([](const JsonValue& fragment) { return fragment.index(0, kNone - 1); });
    if (pair.size() != 2) value["fragments"].fail("expected an array of 2 fragments");
    const JsonValue capacity = value["capacity"], level = value["clusterLevel"];
    return {.fragments = pair.size() == 2 ? std::array{pair[0], pair[1]} : std::array<std::uint32_t, 2>{},
            .area = value["area"].number(above(0.0)),
            .centroid = readVector(value["centroid"]),
            .normal = readVector(value["normal"]),
            .capacity = capacity.isNull() ? std::nullopt : std::optional(capacity.number(atLeast(0.0))),
            .clusterLevel = level.isPresent() ? level.index(0, kEveryLevel - 1) : 0};
}

PackFracture readPackFracture(const JsonValue& value) {
    value.requireKeys({"fragment", "bonds"});
    const JsonValue fragment = value["fragment"];
    return {.fragment = fragment.isNull() ? kNone : fragment.index(0, kNone - 1),
            .bonds = value["bonds"].list(readPackBond)};
}

}  // namespace

void writePackBonding(JsonWriter& json, const PackBonding& bonding) {
    json.openObject("bonding");
    json.number("falloffRadius", bonding.falloffRadius);
    json.text("falloff", kPackFalloffs[static_cast<std::size_t>(bonding.falloff)]);
    json.number("damageFrom", bonding.damageFrom);
    json.number("span", bonding.span);
    json.number("collapseDelay", bonding.collapseDelay);
    json.wholeNumber("minimumIsland", std::uint64_t{bonding.minimumIsland});
    json.text("bake", bonding.bake);
    json.openArray("fractures", JsonLayout::CompactLines);
    for (const PackFracture& fracture : bonding.fractures) writePackFracture(json, fracture);
    json.close();
    json.wholeNumbers("anchored", bonding.anchored);
    json.close();
}

PackBonding readPackBonding(const JsonValue& value) {
    value.requireKeys({"falloffRadius", "falloff", "damageFrom", "span", "collapseDelay", "minimumIsland", "bake",
                       "fractures", "anchored"});
    return {.falloffRadius = value["falloffRadius"].number(above(0.0)),
            .falloff = static_cast<HitFalloff>(value["falloff"].oneOf(kPackFalloffs)),
            .damageFrom = value["damageFrom"].number({.min = 0.0, .max = 1.0, .isMinExcluded = true}),
            .span = value["span"].number(atLeast(0.0)),
            .collapseDelay = value["collapseDelay"].number(atLeast(0.0)),
            .minimumIsland = value["minimumIsland"].index(1),
            .bake = value["bake"].text(),
            .fractures = value["fractures"].list(readPackFracture),
            .anchored = value["anchored"].list([](const JsonValue& one) { return one.index(0, kNone - 1); })};
}

}  // namespace rubble
