#pragma once

#include "core/base/Diagnostic.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/layer/SeedId.h"
#include "core/fracture/pattern/LayerParameters.h"
#include "core/geometry/polygon/Polygon.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

class SolidDomain;

/// One step of a pattern.
struct PatternLayer {
    std::uint32_t id = 0;  // unique in the project
    bool isOn = true;
    std::uint64_t randomSeed = 0;  // shown to the user
    LayerParameters parameters;
    std::vector<SeedOverride> overrides;  // ascending index
    /// The outline in which the layer scattered its seeds, if that was edited since: they stay where they are.
    /// None: the present outline.
    std::optional<Polygon> scatteredIn = std::nullopt;
    bool operator==(const PatternLayer&) const = default;
};

/// An ordered list of layers that place seeds and cuts.
struct Pattern {
    std::vector<PatternLayer> layers;
    bool operator==(const Pattern&) const = default;
};

/// The seeds of a pattern on an outline, or in a closed mesh.
struct Seeds {
    std::vector<Vec2> positions;
    std::vector<double> heights;  // z of each, m; empty: all lie in the plane
    std::vector<SeedId> ids;      // one per position
    /// LostOverride, at the layer and the index of the seed; NoRoom, at the layer, whose value is the number of seeds;
    /// NeedsPlane, at the layer.
    std::vector<Diagnostic> diagnostics;

    Vec3 at(std::size_t seed) const { return {positions[seed], heights.empty() ? 0.0 : heights[seed]}; }
};

/// Returns a sentence that names the first invalid parameter and its layer; nothing if the pattern is valid.
std::optional<std::string> verifyPattern(const Pattern& pattern);

/// The seeds of a pattern on a validated() outline. The same pattern and outline give the same bits.
///
/// Errors: BadInput if verifyPattern() finds a fault; Limit above kMaxSeeds; Crossing if the outline is not
/// valid; Cancelled.
Result<Seeds> seedsOf(const Pattern& pattern, const Polygon& outline, const TaskContext& task = {});

/// The seeds of a pattern in a closed mesh, with heights. They are named as in the plane. Layers that need a plane have
/// no effect. The same pattern and mesh give the same bits.
///
/// Errors: BadInput if verifyPattern() finds a fault; Limit above kMaxSeeds; those of cutWithPattern() if a layer moves
/// seeds; Cancelled.
Result<Seeds> seedsOf(const Pattern& pattern, const SolidDomain& domain, const TaskContext& task = {});

}  // namespace rubble
