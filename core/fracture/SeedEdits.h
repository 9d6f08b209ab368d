#pragma once

#include "core/fracture/Pattern.h"

namespace rubble {

/// Changes to single seeds of a pattern, as a hand makes them. A seed that was placed by hand is changed itself; one that
/// was scattered gets an override. Ids name seeds of the pattern's layers; those of layers that are not there do nothing.

/// Moves a seed, deleted or not, to a position.
void moveSeed(Pattern& pattern, SeedId seed, Vec2 position);
/// Deletes a seed.
void deleteSeed(Pattern& pattern, SeedId seed);
/// Takes back what was done to a scattered seed: it stands where it was thrown again. Does nothing to others.
void restoreSeed(Pattern& pattern, SeedId seed);
/// Adds a seed to a layer of placed seeds and gives its id.
SeedId placeSeed(PatternLayer& layer, Vec2 position);

/// The pattern's layer with an id, or null.
PatternLayer* findLayer(Pattern& pattern, std::uint32_t id);
const PatternLayer* findLayer(const Pattern& pattern, std::uint32_t id);

}  // namespace rubble
