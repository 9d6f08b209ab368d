#pragma once

#include "core/asset/bake/Bake.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubble {

struct PatternKind;

/// A seed of an asset's own pattern that keeps its position in all variants.
struct LockedSeed {
    SeedId id;
    Vec2 position{0.0, 0.0};  // m
    bool operator==(const LockedSeed&) const = default;
};

/// A parameter of one layer with the range of its values; of a count, the range of its amount.
struct VariedParameter {
    std::uint32_t layer = 0;  // id
    std::string parameter;    // its name in files
    double from = 0.0;
    double to = 0.0;
    bool operator==(const VariedParameter&) const = default;
};

/// The settings for generating variants of an asset. The same recipe gives the same variants, bit for bit.
struct VariantRecipe {
    std::uint32_t count = 12;  // see ProjectNumber::Variants
    std::uint64_t randomSeed = 1;
    std::vector<std::string> kinds;       // of layers, as in files, used in turn; empty: the asset's own
    std::vector<VariedParameter> varied;  // uniformly distributed in their ranges
    double spread = 0.15;                 // in [0, 1): largest relative change of a parameter in crossover
    std::vector<LockedSeed> locked;       // ascending id
    bool operator==(const VariantRecipe&) const = default;
};

/// The first fault of a recipe for an asset as a sentence, or nothing: a layer or parameter that is missing or not a
/// number, a range outside that of the parameter, a kind that scatters nothing, a count or spread out of range, a
/// locked seed of a layer that neither scatters nor places seeds.
std::optional<std::string> verifyRecipe(const VariantRecipe& recipe, const Asset& asset);

/// The kinds that the first scattering layer of a variant can take: those that need nothing but parameters.
std::vector<const PatternKind*> variedKinds();

/// Variants of an asset. The first is the asset itself; each other one has its own random seeds on all levels, as
/// variantOf() gives them, a kind for the first scattering layer, and a value for each varied parameter. Locked seeds
/// keep position and name; counts are raised until they exist. Ids, shape and everything else are the asset's.
///
/// Errors: BadInput if verifyRecipe() finds a fault.
Result<std::vector<Asset>> generateVariants(const Asset& asset, const VariantRecipe& recipe);

/// Crosses variants of one asset. The parents come first and stay as they are. Each layer of a child is that of one
/// parent, with its random seed, and its numbers mutated by at most `spread`; points and options are not mutated. Each
/// child without a mutation, and every third child, gets a new random seed in one layer of any level. Levels are those
/// of one parent. `kinds` is ignored; the ranges of `varied` hold.
///
/// Errors: BadInput without parents, or if verifyRecipe() finds a fault outside of `varied`.
Result<std::vector<Asset>> crossoverVariants(std::span<const Asset> parents, const VariantRecipe& recipe);

/// Locks seeds of an asset at their positions in its bake; seeds that are not in it are left out. Ascending id.
std::vector<LockedSeed> lockedIn(const Bake& bake, std::span<const SeedId> seeds);

}  // namespace rubble
