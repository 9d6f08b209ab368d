#pragma once

#include <cstdint>

namespace rubble {

/// What a renderer has asked of the card since it was made.
struct RenderCounts {
    std::uint64_t drawCalls = 0;  // of bodies, shadows and hulls included; the rest of a picture takes a fixed number
    std::uint64_t geometryBytes = 0;  // uploaded: triangles, and which instance has which bodies
    std::uint64_t bodyBytes = 0;      // uploaded: what is a few numbers a body
};

}  // namespace rubble
