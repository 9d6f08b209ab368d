#pragma once

#include "core/play/scene/PlayAsset.h"

namespace rubble {

/// An asset fractured around a point of impact and prepared for play. Half of the seeds (see Asset::cutAtImpact) lie
/// within the falloff radius of the point, denser towards it, the others anywhere in the outline. Its levels fracture
/// the fragments further.
///
/// Seeds near the point keep a distance of 2 mm and of a twentieth of the depth, or of half the mean distance of all
/// seeds where there is no room for that; those without room within the falloff radius lie as near as there is.
///
/// `point`, m, is in the prism's plane; outside the outline it attracts seeds to that side. `number` makes the cut
/// reproducible and different for each body of an asset.
///
/// Errors: those of bake() and playAsset().
/// Source: "Creating Realistic Real-Time Destruction Using the Vienna Physics Engine" (bachelor thesis), 3.3 and
/// outlook.
Result<std::shared_ptr<const PlayAsset>> cutAtImpact(const Asset& asset, Vec2 point, std::uint64_t number);

}  // namespace rubble
