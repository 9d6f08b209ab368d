#pragma once

#include "core/fracture/pattern/Pattern.h"

namespace rubble {

/// Manual changes to single seeds of a pattern. A seed placed by hand is changed directly; a scattered one gets an
/// override. Ids of layers that do not exist are ignored.

/// Moves a seed, even if it is deleted, to a position in the plane, or in space.
void moveSeed(Pattern& pattern, SeedId seed, Vec2 position);
void moveSeed(Pattern& pattern, SeedId seed, Vec3 position);
/// Deletes a seed.
void deleteSeed(Pattern& pattern, SeedId seed);
/// Removes the override of a scattered seed, if it has one.
void restoreSeed(Pattern& pattern, SeedId seed);
/// Adds a seed to a layer of placed seeds and returns its id.
SeedId placeSeed(PatternLayer& layer, Vec2 position);
SeedId placeSeed(PatternLayer& layer, Vec3 position);

/// The pattern's layer with an id, or null.
PatternLayer* findLayer(Pattern& pattern, std::uint32_t id);
const PatternLayer* findLayer(const Pattern& pattern, std::uint32_t id);

}  // namespace rubble
