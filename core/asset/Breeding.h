#pragma once

#include "core/asset/Bake.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// A seed of an asset's own pattern that stays where it is, whatever else varies.
struct LockedSeed {
    SeedId id;
    Vec2 position{0.0, 0.0};  // m
    bool operator==(const LockedSeed&) const = default;
};

/// A parameter of one layer that takes values between two others, or of counts amounts.
struct VariedParameter {
    std::uint32_t layer = 0;  // id
    std::string parameter;    // its name in files
    double from = 0.0;
    double to = 0.0;
    bool operator==(const VariedParameter&) const = default;
};

/// How variants of an asset are made. The same recipe gives the same variants, bit for bit.
struct BreedingRecipe {
    static constexpr std::uint32_t kMostVariants = 1000;

    std::uint32_t count = 12;             // of variants, at most kMostVariants
    std::uint64_t randomSeed = 1;         // another one, other variants
    std::vector<std::string> kinds;       // of layers, as in files; variants take turns. Empty: as the asset has it
    std::vector<VariedParameter> varied;  // each at random within its range
    double spread = 0.15;            // in [0, 1): by what share bred parameters differ from their parents', at most
    std::vector<LockedSeed> locked;  // ascending id
    bool operator==(const BreedingRecipe&) const = default;
};

/// Says in one sentence what is wrong with a recipe for an asset, or nothing: a layer or parameter that is not there or has no
/// numbers, a range outside of what the parameter takes, a kind that scatters nothing, a count or spread out of range, a locked
/// seed whose layer moves or measures.
std::optional<std::string> verifyRecipe(const BreedingRecipe& recipe, const Asset& asset);

/// The kinds of layers that a variant's first scattering layer may become: all that scatter by parameters alone.
std::vector<const PatternKind*> variedKinds();

/// Variants of an asset: the first is the asset as it is; each of the others has random seeds of its own on all levels, as
/// variantOf() gives them, its kind in place of the first layer that scatters, and a value for each varied parameter. Locked seeds stay in place,
/// under their names, and what scatters them throws enough to reach them. Ids, shape and all else are the asset's.
///
/// Errors: BadInput where verifyRecipe() finds a fault.
Result<std::vector<Asset>> variantsOf(const Asset& asset, const BreedingRecipe& recipe);

/// Children of some variants of one asset: each layer is that of one parent, with its random seed, and its numbers are changed by a
/// share of at most `spread`, places and choices left as they are; a child without a change, or every third one, has another
/// random seed in one of its layers, which may be of a level. Levels are those of one parent. The first ones are the parents themselves, so that what was good is not lost. `kinds` are
/// left aside, and of `varied` the ranges hold.
///
/// Errors: BadInput where there is no parent, or verifyRecipe() finds a fault in what is not varied.
Result<std::vector<Asset>> childrenOf(std::span<const Asset> parents, const BreedingRecipe& recipe);

/// Locks seeds of an asset where they stand in a bake of it; those that are not in it are left out. Ascending id.
std::vector<LockedSeed> lockedIn(const Bake& bake, std::span<const SeedId> seeds);

}  // namespace rubble
