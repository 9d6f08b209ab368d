#pragma once

#include <cstdint>

namespace rubble {

/// Statistics of a renderer since its creation.
struct RenderCounts {
    std::uint64_t drawCalls = 0;      // of bodies, including shadows and hulls; all else takes a fixed number per image
    std::uint64_t geometryBytes = 0;  // uploaded: triangles and instance tables
    std::uint64_t bodyBytes = 0;      // uploaded: per-body data
    std::uint64_t triangles = 0;      // of the draw calls
};

}  // namespace rubble
