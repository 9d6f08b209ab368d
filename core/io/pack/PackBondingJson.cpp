#include "core/io/pack/PackBondingJson.h"

#include "core/asset/strength/BondStrength.h"
#include "core/io/json/VectorJson.h"
#include "core/io/pack/PackFormat.h"
#include "core/io/project/BondingJson.h"
#include "core/play/damage/InstanceDamage.h"
#include "core/structure/bonds/Bond.h"
#include "core/structure/clusters/ClusterLevels.h"
#include "core/structure/strength/BondCapacities.h"

#include <cmath>

namespace rubble {
namespace {

void writePackBond(JsonWriter& json, const Bond& bond, std::uint32_t firstFragment, double capacity,
                   std::uint32_t clusterLevel) {
    json.openObject();
    json.wholeNumbers("fragments", std::array{firstFragment + bond.first, firstFragment + bond.second});
    json.number("area", bond.area);
    writeVector(json, "centroid", bond.centroid);
    writeVector(json, "normal", bond.normal);
    json.number("capacity", std::isfinite(capacity) ? std::optional(capacity) : std::nullopt);
    if (clusterLevel > 0) json.wholeNumber("clusterLevel", clusterLevel);
    json.close();
}

void writePackFracture(JsonWriter& json, const Bake& bake, const Asset& asset, const Material& material,
                       std::uint32_t fracture) {
    const BakedFracture& baked = bake.fractures[fracture];
    const std::vector<Bond> bonds = bondsOf(baked.fragments, baked.seeds.positions);
    const std::vector<double> capacities = bondCapacities(asset, material, bake, fracture, bonds);
    const std::vector<ClusterLevel> levels = clusterLevels(asset, bake, fracture, bonds);
    json.openObject();
    json.wholeNumber("fragment", baked.parent == kNone ? std::nullopt : std::optional{baked.parent});
    json.openArray("bonds");
    for (std::size_t k = 0; k < bonds.size(); ++k)
        writePackBond(json, bonds[k], baked.first, capacities[k], levels.empty() ? 0u : levels[k]);
    json.close();
    json.close();
}

PackBond readPackBond(const JsonValue& value) {
    value.requireObject({"fragments", "area", "centroid", "normal", "capacity"}, {"clusterLevel"});
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
    value.requireObject({"fragment", "bonds"});
    const JsonValue fragment = value["fragment"];
    return {.fragment = fragment.isNull() ? kNone : fragment.index(0, kNone - 1),
            .bonds = value["bonds"].list(readPackBond)};
}

}  // namespace

void writePackBonding(JsonWriter& json, const Bake& bake, const Asset& asset, const Material& material) {
    if (asset.breakAs != BreakAs::Bonded) return;
    json.openObject("bonding");
    json.number("falloffRadius", asset.bonding.radius);
    json.text("falloff", kPackFalloffs[static_cast<std::size_t>(asset.bonding.falloff)]);
    json.number("damageFrom", asset.bonding.damageFrom);
    json.number("span", asset.bonding.span);
    json.number("collapseDelay", asset.bonding.collapseDelay);
    json.wholeNumber("minimumIsland", std::uint64_t{asset.bonding.minimumIsland});
    json.text("bake", damageHash(asset, bake).hex());
    json.openArray("fractures", JsonLayout::CompactLines);
    for (std::uint32_t fracture = 0; fracture < bake.fractures.size(); ++fracture) {
        // A body of which there is one fragment only does not break.
        if (bake.fractures[fracture].fragments.count() >= 2) writePackFracture(json, bake, asset, material, fracture);
    }
    json.close();
    const bool doesBreak = !bake.fractures.empty() && bake.fractures[0].fragments.count() >= 2;
    json.wholeNumbers("anchored", doesBreak ? anchoredFragments(asset, bake, 0) : std::vector<std::uint32_t>{});
    json.close();
}

PackBonding readPackBonding(const JsonValue& value) {
    value.requireObject({"falloffRadius", "falloff", "damageFrom", "span", "collapseDelay", "minimumIsland", "bake",
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

void addPackBonding(Hasher& hasher, const Asset& asset, const Material& material) {
    if (asset.breakAs != BreakAs::Bonded) return;
    Asset resolved = asset;
    resolved.bonding.impulsePerArea = bondImpulseOf(asset, material);
    JsonWriter json(JsonLayout::Inline);  // keeps the signs of zeros
    json.openObject();
    writeBonding(json, resolved);
    json.close();
    const std::string text = std::move(json).contents();
    hasher.add(std::uint64_t{text.size()});
    hasher.add(text);
    for (const Level& level : asset.levels) hasher.add(level.bondStrength);
    for (const FragmentLevel& leaf : asset.fragmentLevels) {
        if (leaf.level) hasher.add(leaf.level->bondStrength);
    }
    if (!asset.cutAtImpact) return;
    hasher.add(std::uint64_t{asset.cutAtImpact->fragments});  // of damageHash()
    hasher.add(asset.cutAtImpact->falloffRadius);
}

}  // namespace rubble
