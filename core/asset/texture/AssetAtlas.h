#pragma once

#include "core/asset/mesh/FragmentMesh.h"
#include "core/asset/mesh/RoughCuts.h"
#include "core/asset/texture/TextureAtlas.h"
#include "core/base/TaskContext.h"

namespace rubble {

/// The atlas of an asset: part 0 is the whole, part k + 1 is fragment k of the bake, of any level.
///
/// Errors: those of TextureAtlasBuilder::atlas(); Cancelled.
Result<TextureAtlas> assetAtlas(const Bake& bake, const FragmentMesher& mesher, const RoughCuts& cuts,
                                TexturedSides sides, int side, const TaskContext& task = {});

}  // namespace rubble
