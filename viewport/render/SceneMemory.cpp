#include "viewport/render/SceneMemory.h"

#include "core/base/limits/SoftwareRendererNeeds.h"

#include <span>

namespace rubble {
namespace {

std::size_t bytesOf(const SceneGeometry& geometry) {
    return std::span(geometry.vertices).size_bytes() + std::span(geometry.indices).size_bytes();
}

/// What is uploaded of a scene, bytes, counting what several batches share once for each.
std::size_t geometryBytes(const RenderScene& scene) {
    std::size_t bytes = 0;
    for (const SceneBatch& batch : scene.batches) {
        bytes += bytesOf(*batch.geometry) + (batch.hulls ? bytesOf(*batch.hulls) : 0);
    }
    return bytes;
}

}  // namespace

bool isMemoryLeftFor(const RenderScene& scene) { return isRendererMemoryLeft(geometryBytes(scene)); }

}  // namespace rubble
