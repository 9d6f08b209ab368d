#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/BlueNoise.h"
#include "core/fracture/BrickBond.h"
#include "core/fracture/Clusters.h"
#include "core/fracture/DensityImage.h"
#include "core/fracture/Grain.h"
#include "core/fracture/ImpactScatter.h"
#include "core/fracture/JitteredGrid.h"
#include "core/fracture/LloydRelaxation.h"
#include "core/fracture/PlacedSeeds.h"
#include "core/fracture/RadialPattern.h"
#include "core/fracture/Report.h"
#include "core/fracture/Slices.h"
#include "core/fracture/Strokes.h"
#include "core/fracture/UniformScatter.h"
#include "core/fracture/WeightedLloyd.h"
#include "core/geometry/Polygon.h"

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rubble {

/// What a layer does: one struct a kind. See PatternKind.h for what is known of each. Hashes and files hold a kind's place: new
/// ones go to the end.
using LayerParameters =
    std::variant<UniformScatter, BlueNoise, PlacedSeeds, LloydRelaxation, JitteredGrid, Clusters, RadialPattern,
                 ImpactScatter, DensityImage, BrickBond, Slices, Strokes, Grain, WeightedLloyd>;

/// A change made by hand to one scattered seed of a layer.
struct SeedOverride {
    std::uint32_t index = 0;  // of the seed in its layer
    bool isDeleted = false;
    Vec2 position{0.0, 0.0};  // where it was moved to, unless deleted
    bool operator==(const SeedOverride&) const = default;
};

/// One step of the recipe.
struct PatternLayer {
    std::uint32_t id = 0;  // unique in the project
    bool isOn = true;
    std::uint64_t randomSeed = 0;  // shown to the artist
    LayerParameters parameters;
    std::vector<SeedOverride> overrides;  // ascending index
    bool operator==(const PatternLayer&) const = default;
};

/// An ordered recipe for seeds.
struct Pattern {
    std::vector<PatternLayer> layers;
    bool operator==(const Pattern&) const = default;
};

/// A seed's name: it stays when other seeds come, go or move.
struct SeedId {
    std::uint32_t layer = 0;  // the layer's id
    std::uint32_t index = 0;  // within the layer
    auto operator<=>(const SeedId&) const = default;
    /// "layer.index"
    std::string text() const;
};

/// What a pattern gives on an outline.
struct Seeds {
    std::vector<Vec2> positions;
    std::vector<SeedId> ids;  // one a position
    std::vector<Report>
        reports;  // LostOverride (`seed`: index in the layer), NoRoom (`amount`: seeds found); `of`: layer id
};

/// Seeds that one pattern may give; beyond it memory and patience end.
inline constexpr std::uint32_t kMostSeeds = 10'000'000;

/// Says in one sentence which parameter of which layer is not finite or out of range, or nothing where all is well.
std::optional<std::string> verifyPattern(const Pattern& pattern);

/// Carries out the recipe on a validated() outline. Same pattern, same outline, same bits.
///
/// Errors: BadInput where verifyPattern() finds a fault; Limit above kMostSeeds; Crossing where the outline is not
/// valid; Cancelled.
Result<Seeds> seedsOf(const Pattern& pattern, const Polygon& outline, const TaskContext& task = {});

}  // namespace rubble
