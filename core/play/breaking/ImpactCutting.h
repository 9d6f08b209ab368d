#pragma once

#include "core/play/scene/PlayAsset.h"

namespace rubble {

/// An asset fractured around a point of impact and prepared for play. Half of the seeds (see Asset::cutAtImpact) lie
/// within the falloff radius of the point, denser towards it, the others anywhere in the outline or the mesh. Its
/// levels fracture the fragments further.
///
/// Seeds near the point keep a distance: in a prism of 2 mm and of a twentieth of the depth, in a mesh of 2 mm and of a
/// fifth of the mean distance of all seeds; or of half that mean distance where there is no room for that. Those
/// without room within the falloff radius lie as near as there is.
///
/// `point`, m, is in the asset's frame, for a prism in its plane whatever z is; outside it attracts seeds to that side.
/// `uncut`: the asset as its pattern fractures it, from which the whole is taken, so that it is not made again; else
/// the result is the same. `number` makes the cut reproducible and different for each body of an asset.
///
/// Errors: those of bake() and playAsset().
/// Source: "Creating Realistic Real-Time Destruction Using the Vienna Physics Engine" (bachelor thesis), 3.3 and
/// outlook.
Result<std::shared_ptr<const PlayAsset>> cutAtImpact(const Asset& asset, Vec3 point, std::uint64_t number,
                                                     const PlayAsset* uncut = nullptr);

}  // namespace rubble
