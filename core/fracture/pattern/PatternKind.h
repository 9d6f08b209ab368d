#pragma once

#include "core/base/Random.h"
#include "core/fracture/pattern/LayerParameter.h"

#include <optional>
#include <string>
#include <vector>

namespace rubble {

// A kind of layer is a struct with its parameters, `apply()` or `cut()`, and `kKind` in a header and .cpp of its own;
// an entry at the end of LayerParameters; and a test. Its kKind describes it completely for files, hashes and the
// editor. A kind that holds more than parameters, such as manually placed seeds, has a `fault()`, too.

/// What a layer contributes to a pattern.
enum class LayerRole {
    Scatters,  // adds random seeds, which may have overrides
    Places,    // adds its own seeds
    Moves,     // moves the seeds of the layers before
    Cuts,      // cuts pieces along lines: cut() instead of apply()
    Measures,  // changes the metric of the Voronoi cells of all seeds: no apply()
};

/// The description of a kind of layer. Texts for users are English; translations use them as keys.
struct PatternKind {
    std::string_view name;  // in files: "blueNoise"
    const char* caption;    // "Blue noise"
    const char* hint;       // what it does, in a few words
    const char* icon;       // "layer-blue-noise", a file in resources/icons
    /// A template that describes a layer in a list, after the caption: "{minimumDistance} apart". Braces enclose the
    /// name of a parameter, or "elements" for elementCount(), and optionally the texts for one and for more: "{rounds|1
    /// round|%1 rounds}".
    const char* (*summary)(const LayerParameters& parameters);
    LayerRole role;
    std::span<const LayerParameter> parameters;  // in the order of files
    /// The initial parameters of a new layer in a domain with these bounds.
    LayerParameters (*defaultsFor)(const Box2& bounds);
    bool isRandom = false;  // the layer's random seed has an effect
    /// The number of elements that a layer holds besides its parameters, such as placed seeds; null: it holds none.
    std::size_t (*elementCount)(const LayerParameters& parameters) = nullptr;
};

/// The kind of a layer.
const PatternKind& kindOf(const LayerParameters& parameters);
/// All kinds, in the order of LayerParameters.
std::span<const PatternKind* const> patternKinds();

/// The seeds while a pattern is evaluated.
struct SeedSet {
    std::vector<Vec2> positions;
    std::vector<SeedId> ids;     // one per position
    std::vector<bool> isLocked;  // placed or moved by hand: relaxation does not move it
    std::vector<Diagnostic> diagnostics;

    std::size_t size() const { return positions.size(); }
    void add(SeedId id, Vec2 position, bool locked);
    /// Reserves memory for additional seeds.
    void reserve(std::size_t additional);
};

/// The input of a layer's apply(), which adds seeds with ascending indices to those of the layers before, or moves
/// those.
struct LayerContext {
    const PatternLayer& layer;
    const Polygon& outline;  // validated
    const TaskContext& task;
    std::span<const PatternLayer> before = {};  // disabled ones included
    const Pattern* pattern = nullptr;           // the whole pattern; null: only this layer

    /// The layer's own random stream, from its start.
    Random random() const { return Random(mixSeeds(layer.randomSeed, layer.id)); }
    /// The random stream of one of its seeds, cuts or clusters.
    Random randomOf(std::uint64_t index) const { return Random(mixSeeds(mixSeeds(layer.randomSeed, layer.id), index)); }
    /// "Layer 4", for the start of a sentence.
    std::string name() const;
    /// Whether the task is cancelled; tests only every 1024th round of a loop.
    bool isCancelledAt(std::size_t round) const { return round % 1024 == 0 && task.isCancelled(); }
};

/// The error of a pattern with too many seeds.
Error tooManySeeds(const LayerContext& context);

/// The number of seeds of a count in a domain. Errors: Limit if there are too many, together with those before.
Result<std::uint32_t> seedsToAdd(const SeedCount& count, const Polygon& domain, const LayerContext& context,
                                 const SeedSet& seeds);

/// Adds `count` seeds at area.point(random), one after the other. Errors: Cancelled.
template <class Area>
Status scatter(std::uint32_t count, const Area& area, const LayerContext& context, SeedSet& seeds) {
    Random random = context.random();
    seeds.reserve(count);
    for (std::uint32_t index = 0; index < count; ++index) {
        if (context.isCancelledAt(index)) return TaskContext::cancelled();
        seeds.add({context.layer.id, index}, area.point(random), false);
    }
    return success();
}

}  // namespace rubble
