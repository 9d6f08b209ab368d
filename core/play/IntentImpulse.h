#pragma once

#include "core/play/PlayAsset.h"

namespace rubble {

/// What an intent's event does to an asset, N s: what a session would hold against its threshold at the first touch, by the
/// project's rule of damage; 0 where the touch is too slow to do any.
///
/// In closed form: falling from a height h it lands at sqrt(2 g h), hit it stands free and still. The two are placed as they
/// touch, with their speeds; where they touch, and with it the effective mass, is told by one look at them, and nothing is
/// simulated. Of several hulls that touch at once the hardest hit counts. What comes after the first touch, such as
/// tipping over, does not.
/// A drop is onto level ground of the project's restitution, under the project's gravity. `asset` is one of the project's.
///
/// Errors: BadInput for a drop where gravity does not point straight down; those of missile() and World::addBody(), for a mass or
/// a speed beyond what can be simulated.
Result<double> intentImpulse(const Project& project, const PlayAsset& asset, const Intent& intent);

/// The throw that a hit is, in the prism's frame: a cube of 0.2 m, or a fifth of the outline where that is less, which starts
/// where it touches the front (z > 0) head on, behind the centre of mass. Where the outline is open there, at the nearest
/// point of it.
Throw hitThrow(const Project& project, const PlayAsset& asset, const HitIntent& hit);

}  // namespace rubble
