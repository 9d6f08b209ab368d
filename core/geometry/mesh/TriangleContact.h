#pragma once

#include "core/geometry/mesh/LatticeSurface.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rubble {

/// How two triangles meet, beyond a common edge or corner.
enum class TriangleContact {
    None,   // not at all, or in a point
    Line,   // in a segment that lies in an edge of one of them at least; or in one plane, and perhaps not at all
    Face,   // in an area, facing opposite ways
    Cross,  // in a segment inside both, or in an area that faces the same way for both
};
TriangleContact contactOf(const LatticeSurface& surface, std::uint32_t a, std::uint32_t b);

/// Two triangles, the lower index first.
using TrianglePair = std::array<std::uint32_t, 2>;

/// What lies between two triangles with a contact of faces: nothing, with solid on both sides, or solid, with nothing
/// on both sides.
enum class FaceLayer { Gap, Solid };

/// What the surroundings of a segment say about contacts of faces beside it.
struct FaceLayers {
    struct Known {
        TrianglePair pair;
        FaceLayer layer = FaceLayer::Gap;
        bool operator==(const Known&) const = default;
        auto operator<=>(const Known&) const = default;
    };
    std::vector<Known> known;
    std::vector<std::array<TrianglePair, 2>> same;  // pairs with one layer, whichever
};

/// How surfaces meet at the edges of two triangles with a contact of a line or face.
enum class EdgePassage {
    None,
    Touch,
    Cross,  // to the other side: no numbers 0 and 1 for outside and inside fit the space around an edge
};
/// Appends what is known of layers.
EdgePassage passageAtEdges(const LatticeSurface& surface, std::uint32_t a, std::uint32_t b, FaceLayers& layers);

/// A point of two triangles that meet, rounded.
Vec3 commonPoint(const LatticeSurface& surface, std::uint32_t a, std::uint32_t b);

}  // namespace rubble
