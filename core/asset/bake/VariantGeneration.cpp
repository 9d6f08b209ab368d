#include "core/asset/bake/VariantGeneration.h"

#include "core/asset/project/AssetShape.h"
#include "core/asset/project/Ranges.h"
#include "core/asset/project/Variants.h"
#include "core/base/MessageText.h"
#include "core/base/Random.h"
#include "core/fracture/pattern/PatternKind.h"
#include "core/geometry/polygon/Polygon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble {
namespace {

constexpr std::uint32_t kNewSeedEvery = 3;  // of so many children one gets a new random seed
constexpr double kAngleSpread =
    std::numbers::pi / 2.0;  // rad: angles are mutated relative to it, since they have no magnitude

bool scatters(const PatternLayer& layer) { return kindOf(layer.parameters).role == LayerRole::Scatters; }

const LayerParameter* findParameter(const LayerParameters& of, std::string_view name) {
    const std::span<const LayerParameter> all = kindOf(of).parameters;
    const auto found = std::ranges::find(all, name, &LayerParameter::name);
    return found != all.end() ? &*found : nullptr;
}

bool hasNumbers(const LayerParameter& parameter) {
    return parameter.type == ParameterType::Whole || parameter.type == ParameterType::Real ||
           parameter.type == ParameterType::Count;
}

double numberOf(const LayerParameter& parameter, const LayerParameters& of) {
    const ParameterValue value = parameter.read(of);
    const auto* count = std::get_if<SeedCount>(&value);
    return count ? count->amount : std::get<double>(value);
}

/// Writes a number, rounded if the parameter is a whole number.
void setNumber(const LayerParameter& parameter, LayerParameters& of, double number) {
    const ParameterValue value = parameter.read(of);
    if (const auto* count = std::get_if<SeedCount>(&value)) {
        const bool isWhole = count->by == CountBy::Number;
        return parameter.write(of, SeedCount(count->by, isWhole ? std::round(number) : number));
    }
    parameter.write(of, parameter.type == ParameterType::Whole ? std::round(number) : number);
}

/// True if the parameter accepts the number, in its current unit of counting.
bool accepts(const LayerParameter& parameter, const LayerParameters& of, double number) {
    LayerParameters tried = of;
    setNumber(parameter, tried, number);
    return !parameterFault(parameter, parameter.read(tried));
}

/// Raises the count, if it is a number of seeds, so that the seed with index `last` exists.
void raiseCountTo(std::uint32_t last, LayerParameters& parameters) {
    const LayerParameter* count = findParameter(parameters, "count");
    if (!count || count->type != ParameterType::Count) return;
    const auto current = std::get<SeedCount>(count->read(parameters));
    if (current.by == CountBy::Number) setNumber(*count, parameters, std::max(current.amount, last + 1.0));
}

/// Overrides the positions of the locked seeds of a layer.
void applyLocks(std::span<const LockedSeed> locked, PatternLayer& layer) {
    for (const LockedSeed& seed : locked) {
        if (seed.id.layer != layer.id || !scatters(layer)) continue;
        layer.overrides.push_back({.index = seed.id.index, .position = seed.position});
        raiseCountTo(seed.id.index, layer.parameters);
    }
    std::ranges::sort(layer.overrides, {}, &SeedOverride::index);
}

/// Replaces the kind of a layer, keeping its count.
void setKind(const PatternKind& kind, const Box2& bounds, PatternLayer& layer) {
    LayerParameters parameters = kind.defaultsFor(bounds);
    const LayerParameter* from = findParameter(layer.parameters, "count");
    const LayerParameter* to = findParameter(parameters, "count");
    if (from && to && from->type == to->type) to->write(parameters, from->read(layer.parameters));
    if (kindOf(layer.parameters).name != kind.name) layer.parameters = parameters;
}

const PatternKind* findKind(std::string_view name) {
    const std::vector<const PatternKind*> kinds = variedKinds();
    const auto found = std::ranges::find(kinds, name, &PatternKind::name);
    return found != kinds.end() ? *found : nullptr;
}

void mixIn(std::uint64_t randomSeed, Pattern& pattern) {
    for (PatternLayer& layer : pattern.layers) layer.randomSeed = mixSeeds(layer.randomSeed, randomSeed);
}

Asset variant(const Asset& asset, const VariantRecipe& recipe, std::uint32_t number) {
    Asset made = variantOf(asset, number);
    made.name = asset.name;
    Random random(mixSeeds(recipe.randomSeed, number));
    mixIn(recipe.randomSeed, made.pattern);
    for (Level& level : made.levels) mixIn(recipe.randomSeed, level.pattern);
    const auto first = std::ranges::find_if(made.pattern.layers, scatters);
    if (!recipe.kinds.empty() && first != made.pattern.layers.end()) {
        const PatternKind* kind = findKind(recipe.kinds[(number - 1) % recipe.kinds.size()]);
        setKind(*kind, planeBoundsOf(asset), *first);
    }
    for (const VariedParameter& varied : recipe.varied) {
        const double value = random.between(varied.from, varied.to);
        const auto layer = std::ranges::find(made.pattern.layers, varied.layer, &PatternLayer::id);
        const LayerParameter* parameter = findParameter(layer->parameters, varied.parameter);
        if (parameter && accepts(*parameter, layer->parameters, value)) setNumber(*parameter, layer->parameters, value);
    }
    for (PatternLayer& layer : made.pattern.layers) applyLocks(recipe.locked, layer);
    return made;
}

/// A parent's number as it becomes in a child.
double mutated(double number, const LayerParameter& parameter, double spread, Random& random) {
    const double change = random.between(-spread, spread);
    if (parameter.quantity == Quantity::Angle) return number + change * kAngleSpread;
    return change < 0.0 ? number / (1.0 - change) : number * (1.0 + change);  // symmetric up and down
}

void mutate(const VariantRecipe& recipe, Random& random, PatternLayer& layer) {
    for (const LayerParameter& parameter : kindOf(layer.parameters).parameters) {
        if (!hasNumbers(parameter) || !parameter.isUsed(layer.parameters)) continue;
        double number = mutated(numberOf(parameter, layer.parameters), parameter, recipe.spread, random);
        for (const VariedParameter& varied : recipe.varied) {
            if (varied.layer == layer.id && varied.parameter == parameter.name) {
                number = std::clamp(number, varied.from, varied.to);
            }
        }
        if (accepts(parameter, layer.parameters, number)) setNumber(parameter, layer.parameters, number);
    }
}

const PatternLayer& layerOf(const Asset& parent, const PatternLayer& like) {
    const auto found = std::ranges::find(parent.pattern.layers, like.id, &PatternLayer::id);
    return found != parent.pattern.layers.end() ? *found : like;
}

Asset child(std::span<const Asset> parents, const VariantRecipe& recipe, std::uint32_t number) {
    Random random(mixSeeds(splitmix64(recipe.randomSeed), number));
    Asset made = parents[random.below(parents.size())];
    bool isChanged = false;
    std::vector<PatternLayer*> scattering;
    for (PatternLayer& layer : made.pattern.layers) {
        layer = layerOf(parents[random.below(parents.size())], layer);
        const LayerParameters before = layer.parameters;
        mutate(recipe, random, layer);
        isChanged = isChanged || layer.parameters != before;
        if (!scatters(layer)) continue;
        layer.overrides.clear();
        applyLocks(recipe.locked, layer);
        scattering.push_back(&layer);
    }
    const std::size_t ownCount = scattering.size();
    for (Level& level : made.levels) {  // of one parent
        for (PatternLayer& layer : level.pattern.layers) {
            if (scatters(layer)) scattering.push_back(&layer);
        }
    }
    const bool hasNewSeed = !isChanged || number % kNewSeedEvery == 0;
    if (hasNewSeed && !scattering.empty()) {
        const std::size_t picked = random.below(scattering.size());
        scattering[picked]->randomSeed = random.next();
        if (picked >= ownCount) scattering[picked]->overrides.clear();  // they were made for other seeds
    }
    made.fragmentLevels.clear();  // this and the next four: they refer to the old fragments
    made.fragmentThresholds.clear();
    made.bonding.neverBreaks.clear();
    made.bonding.clusters.clear();
    made.edits.clear();
    return made;
}

std::optional<std::string> fault(const VariedParameter& varied, const Asset& asset) {
    const auto layer = std::ranges::find(asset.pattern.layers, varied.layer, &PatternLayer::id);
    const std::string name = "Layer " + std::to_string(varied.layer);
    if (layer == asset.pattern.layers.end())
        return name + " cannot vary: " + quotedName(asset.name) + " has no such layer.";
    const LayerParameter* parameter = findParameter(layer->parameters, varied.parameter);
    if (!parameter || !hasNumbers(*parameter)) {
        return name + ": " + quotedName(varied.parameter) + " cannot vary: it is not a number of a layer of kind " +
               quotedName(kindOf(layer->parameters).name) + ".";
    }
    const std::string range = messageText(varied.from) + " to " + messageText(varied.to);
    const bool isOrdered = varied.from <= varied.to;  // false for NaN, too
    if (!isOrdered)
        return name + ": " + quotedName(varied.parameter) + " cannot vary from " + range + ": the range is empty.";
    if (accepts(*parameter, layer->parameters, varied.from) && accepts(*parameter, layer->parameters, varied.to)) {
        return std::nullopt;
    }
    return name + ": " + quotedName(varied.parameter) + " cannot vary from " + range +
           ": the parameter does not accept these values.";
}

std::optional<std::string> fault(const LockedSeed& locked, const Asset& asset) {
    const auto layer = std::ranges::find(asset.pattern.layers, locked.id.layer, &PatternLayer::id);
    const bool isThere = layer != asset.pattern.layers.end();
    if (isThere && (scatters(*layer) || kindOf(layer->parameters).role == LayerRole::Places)) return std::nullopt;
    return "Seed " + locked.id.text() + " cannot be locked: " + quotedName(asset.name) + " has no such layer of seeds.";
}

/// The first fault of a recipe apart from its varied parameters: in crossover a parent may have another kind.
std::optional<std::string> faultForChildren(const VariantRecipe& recipe, const Asset& asset) {
    if (const NumberRange& range = rangeOf(ProjectNumber::Variants); !range.contains(recipe.count)) {
        return "The number of variants is " + std::to_string(recipe.count) + ", but must be " + rangeText(range) + ".";
    }
    const bool isSpread = recipe.spread >= 0.0 && recipe.spread < 1.0;  // false for NaN, too
    if (!isSpread) return "The spread is " + messageText(recipe.spread) + ", but must be from 0 to less than 1.";
    for (const std::string& kind : recipe.kinds) {
        if (!findKind(kind)) return quotedName(kind) + " is not a kind of layer that can scatter seeds in variants.";
    }
    for (const LockedSeed& locked : recipe.locked) {
        if (std::optional<std::string> found = fault(locked, asset)) return found;
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> verifyRecipe(const VariantRecipe& recipe, const Asset& asset) {
    for (const VariedParameter& varied : recipe.varied) {
        if (std::optional<std::string> found = fault(varied, asset)) return found;
    }
    return faultForChildren(recipe, asset);
}

std::vector<const PatternKind*> variedKinds() {
    std::vector<const PatternKind*> kinds;
    for (const PatternKind* kind : patternKinds()) {
        const bool needsPicture = kind == &kindOf(DensityImage{});
        if (kind->role == LayerRole::Scatters && !needsPicture) kinds.push_back(kind);
    }
    return kinds;
}

Result<std::vector<Asset>> generateVariants(const Asset& asset, const VariantRecipe& recipe) {
    if (const auto wrong = verifyRecipe(recipe, asset)) return Error{ErrorCode::BadInput, *wrong};
    std::vector<Asset> variants{asset};
    for (std::uint32_t k = 1; k < recipe.count; ++k) variants.push_back(variant(asset, recipe, k));
    return variants;
}

Result<std::vector<Asset>> crossoverVariants(std::span<const Asset> parents, const VariantRecipe& recipe) {
    if (parents.empty()) return Error{ErrorCode::BadInput, "No variant is selected as a parent."};
    for (const Asset& parent : parents) {
        if (const auto wrong = faultForChildren(recipe, parent)) return Error{ErrorCode::BadInput, *wrong};
    }
    std::vector<Asset> children(parents.begin(), parents.end());
    if (children.size() > recipe.count) children.resize(recipe.count);
    while (children.size() < recipe.count) {
        children.push_back(child(parents, recipe, static_cast<std::uint32_t>(children.size())));
    }
    return children;
}

std::vector<LockedSeed> lockedIn(const Bake& bake, std::span<const SeedId> seeds) {
    std::vector<LockedSeed> locked;
    if (bake.fractures.empty()) return locked;
    const Seeds& all = bake.fractures.front().seeds;
    for (std::size_t k = 0; k < all.ids.size(); ++k) {
        if (std::ranges::find(seeds, all.ids[k]) != seeds.end()) locked.push_back({all.ids[k], all.positions[k]});
    }
    std::ranges::sort(locked, {}, &LockedSeed::id);
    return locked;
}

}  // namespace rubble
