#pragma once

#include "core/base/Random.h"
#include "core/fracture/Pattern.h"

#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// The seeds while a recipe is carried out.
struct SeedSet {
    std::vector<Vec2> positions;
    std::vector<SeedId> ids;   // one a position
    std::vector<bool> isHeld;  // placed or moved by hand: relaxation leaves it where it is
    std::vector<Report> reports;

    std::size_t size() const { return positions.size(); }
    void add(SeedId id, Vec2 position, bool held);
};

/// What a layer works with.
struct LayerContext {
    const PatternLayer& layer;
    const Polygon& outline;  // validated
    const TaskContext& task;

    /// The layer's own stream of random numbers, always from its start.
    Random random() const { return Random(mixedWith(layer.randomSeed, layer.id)); }
    /// "Layer 4", as sentences begin.
    std::string name() const;
    /// True now and then where the task was cancelled; made for a call in every round of a loop.
    bool isCancelledAt(std::size_t round) const { return round % 1024 == 0 && task.isCancelled(); }
};

/// The fault of a pattern that gives too many seeds.
Error tooManySeeds(const LayerContext& context);

// A kind of layer is its parameters in LayerParameters, these two functions in a file of its own, and a test:
//   parameterFault  what is wrong with the parameters, as the end of a sentence that begins with the layer's name
//   applyLayer      adds seeds with ascending indices to those of the layers before, or moves those
std::optional<std::string> parameterFault(const UniformScatter& scatter);
Status applyLayer(const UniformScatter& scatter, const LayerContext& context, SeedSet& seeds);

std::optional<std::string> parameterFault(const BlueNoise& noise);
Status applyLayer(const BlueNoise& noise, const LayerContext& context, SeedSet& seeds);

std::optional<std::string> parameterFault(const PlacedSeeds& placed);
Status applyLayer(const PlacedSeeds& placed, const LayerContext& context, SeedSet& seeds);

std::optional<std::string> parameterFault(const LloydRelaxation& relaxation);
Status applyLayer(const LloydRelaxation& relaxation, const LayerContext& context, SeedSet& seeds);

}  // namespace rubble
