#pragma once

#include "core/asset/finish/AssetFinish.h"
#include "core/asset/texture/TextureAtlas.h"
#include "core/base/TaskContext.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// Square images of one size: three bytes a texel, rows from top to bottom.
struct BakedMaps {
    int side = 0;                       // texels
    std::vector<std::uint8_t> colour;   // sRGB
    std::vector<std::uint8_t> normal;   // in the tangent's frame: 128 is 0, 255 is 1; green is upwards, as in OpenGL
    std::vector<std::uint8_t> surface;  // 255, roughness, metalness: as glTF packs occlusion with them
};

/// Computes finishes at all texels of an atlas, with task.threads threads. The same bits on any number of them, and on
/// every machine.
///
/// Errors: Cancelled.
Result<BakedMaps> bakedMaps(const TextureAtlas& atlas, const SurfaceFinish& outside, const SurfaceFinish& inside,
                            const TaskContext& task = {});

}  // namespace rubble
