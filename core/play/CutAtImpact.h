#pragma once

#include "core/play/PlayAsset.h"

namespace rubble {

/// An asset cut anew where it is hit, made ready: half of its seeds (asset.cutAtImpact says how many) lie within the reach of a
/// point, thrown at random and denser towards it; the others anywhere in the outline. Its levels break the pieces again.
///
/// `point`: in the prism's plane, m; one outside the outline draws the seeds to the outline's side of it. `number`: of this cut, so
/// that no two bodies of an asset are cut alike; the same numbers give the same pieces.
///
/// Errors: those of bake() and playAsset().
/// Source: the thesis, 3.3 and its outlook.
Result<std::shared_ptr<const PlayAsset>> cutAtImpact(const Asset& asset, Vec2 point, std::uint64_t number);

}  // namespace rubble
