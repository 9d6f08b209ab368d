#pragma once

#include "core/base/Diagnostic.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/pattern/BlueNoise.h"
#include "core/fracture/pattern/BrickBond.h"
#include "core/fracture/pattern/Clusters.h"
#include "core/fracture/pattern/CrackLines.h"
#include "core/fracture/pattern/DensityImage.h"
#include "core/fracture/pattern/Grain.h"
#include "core/fracture/pattern/ImpactScatter.h"
#include "core/fracture/pattern/JitteredGrid.h"
#include "core/fracture/pattern/LloydRelaxation.h"
#include "core/fracture/pattern/PlacedSeeds.h"
#include "core/fracture/pattern/RadialPattern.h"
#include "core/fracture/pattern/Slices.h"
#include "core/fracture/pattern/UniformScatter.h"
#include "core/fracture/pattern/WeightedLloyd.h"
#include "core/geometry/polygon/Polygon.h"

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rubble {

/// The parameters of a layer: one struct per kind, see PatternKind.h. Hashes hold the index of a kind: add new ones at
/// the end.
using LayerParameters =
    std::variant<UniformScatter, BlueNoise, PlacedSeeds, LloydRelaxation, JitteredGrid, Clusters, RadialPattern,
                 ImpactScatter, DensityImage, BrickBond, Slices, CrackLines, Grain, WeightedLloyd>;

/// A manual change to one scattered seed of a layer.
struct SeedOverride {
    std::uint32_t index = 0;  // of the seed in its layer
    bool isDeleted = false;
    Vec2 position{0.0, 0.0};  // its new position, unless deleted
    bool operator==(const SeedOverride&) const = default;
};

/// One step of a pattern.
struct PatternLayer {
    std::uint32_t id = 0;  // unique in the project
    bool isOn = true;
    std::uint64_t randomSeed = 0;  // shown to the user
    LayerParameters parameters;
    std::vector<SeedOverride> overrides;  // ascending index
    bool operator==(const PatternLayer&) const = default;
};

/// An ordered list of layers that place seeds and cuts.
struct Pattern {
    std::vector<PatternLayer> layers;
    bool operator==(const Pattern&) const = default;
};

/// A persistent seed id: it does not change when other seeds are added, deleted or moved.
struct SeedId {
    std::uint32_t layer = 0;  // the layer's id
    std::uint32_t index = 0;  // within the layer
    auto operator<=>(const SeedId&) const = default;
    /// "layer.index"
    std::string text() const;
};

/// The seed or cut that a diagnostic is about; nothing if it is about none.
std::optional<SeedId> seedOf(const DiagnosticPlace& place);

/// The seeds of a pattern on an outline.
struct Seeds {
    std::vector<Vec2> positions;
    std::vector<SeedId> ids;  // one per position
    /// LostOverride (`seed`: index in the layer), NoRoom (`amount`: seeds placed); `of`: layer id.
    std::vector<Diagnostic> diagnostics;
};

/// The maximum number of seeds of a pattern; more would need too much memory and time.
inline constexpr std::uint32_t kMaxSeeds = 10'000'000;

/// Returns a sentence that names the first invalid parameter and its layer; nothing if the pattern is valid.
std::optional<std::string> verifyPattern(const Pattern& pattern);

/// The seeds of a pattern on a validated() outline. The same pattern and outline give the same bits.
///
/// Errors: BadInput if verifyPattern() finds a fault; Limit above kMaxSeeds; Crossing if the outline is not
/// valid; Cancelled.
Result<Seeds> seedsOf(const Pattern& pattern, const Polygon& outline, const TaskContext& task = {});

}  // namespace rubble
