#pragma once

#include "core/base/Random.h"
#include "core/fracture/LayerParameter.h"

#include <optional>
#include <string>
#include <vector>

namespace rubble {

// A kind of layer is a struct with its parameters, `apply()` and `kKind` in a header and a .cpp of its own; a place at the
// end of LayerParameters; and a test. What is told of it there is all that files, hashes and the editor need to know, but
// for an icon. A kind that holds more than parameters, as seeds placed by hand, has a fault(), too.

enum class LayerRole {
    Scatters,  // adds seeds that follow from a random seed and may be overridden
    Places,    // adds seeds that it holds itself
    Moves,     // adds none; moves those of the layers before
    Cuts,      // adds none; cuts pieces along lines of its own: cut() in place of apply()
    Measures,  // adds none; says how distances count between all seeds: nothing in place of apply()
};

/// What is told of a kind of layer. Texts for users are English, and the keys of their translations.
struct PatternKind {
    std::string_view name;  // in files: "blueNoise"
    const char* caption;    // "Blue noise"
    const char* hint;       // what it adds, in a few words
    LayerRole role;
    std::span<const LayerParameter> parameters;  // in the order of files
    /// The parameters with which a new layer begins, given the box around what it is to fill.
    LayerParameters (*suitedTo)(const Box2& bounds);
};

/// The kind of a layer.
const PatternKind& kindOf(const LayerParameters& parameters);
/// All kinds, in the order of LayerParameters.
std::span<const PatternKind* const> patternKinds();

/// The seeds while a recipe is carried out.
struct SeedSet {
    std::vector<Vec2> positions;
    std::vector<SeedId> ids;   // one a position
    std::vector<bool> isHeld;  // placed or moved by hand: relaxation leaves it where it is
    std::vector<Report> reports;

    std::size_t size() const { return positions.size(); }
    void add(SeedId id, Vec2 position, bool held);
    /// Makes room for so many more.
    void expect(std::size_t count);
};

/// What a layer works with, and what those before it are. Its apply() adds seeds with ascending indices to those of the layers before, or moves those.
struct LayerContext {
    const PatternLayer& layer;
    const Polygon& outline;  // validated
    const TaskContext& task;
    std::span<const PatternLayer> before = {};  // those that are off, too
    const Pattern* pattern = nullptr;           // the whole recipe; null: the layer alone

    /// The layer's own stream of random numbers, always from its start.
    Random random() const { return Random(mixedWith(layer.randomSeed, layer.id)); }
    /// A stream for one of its seeds or of what else it counts.
    Random randomOf(std::uint64_t index) const {
        return Random(mixedWith(mixedWith(layer.randomSeed, layer.id), index));
    }
    /// "Layer 4", as sentences begin.
    std::string name() const;
    /// True now and then where the task was cancelled; made for a call in every round of a loop.
    bool isCancelledAt(std::size_t round) const { return round % 1024 == 0 && task.isCancelled(); }
};

/// The fault of a pattern that gives too many seeds.
Error tooManySeeds(const LayerContext& context);

/// How many seeds a count means in an area that is filled. Errors: Limit where there are too many with those before.
Result<std::uint32_t> seedsToAdd(const SeedCount& count, const Polygon& filled, const LayerContext& context,
                                 const SeedSet& seeds);

/// Adds a layer's first `count` seeds where area.point(random) says, one after the other. Errors: Cancelled.
template <class Area>
Status scatter(std::uint32_t count, const Area& area, const LayerContext& context, SeedSet& seeds) {
    Random random = context.random();
    seeds.expect(count);
    for (std::uint32_t index = 0; index < count; ++index) {
        if (context.isCancelledAt(index)) return TaskContext::cancelled();
        seeds.add({context.layer.id, index}, area.point(random), false);
    }
    return success();
}

}  // namespace rubble
