#pragma once

#include "core/structure/bonds/Bond.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A straight edge between two fragments in the prism's plane. Extruded, it is part of the face of their bond.
struct FaceEdge {
    std::uint32_t bond = 0;  // index
    Vec2 from{0.0};          // m; with Fragments::origin added, in the frame of Fragment::offset()
    Vec2 to{0.0};
    bool startsOutside = false;  // `from` is on the outline of all fragments
    bool endsOutside = false;    // and `to`
};

/// The edges of the faces of bonds, by piece, each once. `bonds`: by first, then second, as bondsOf() has
/// them; edges between fragments without a bond are left out. None for fragments of a
/// mesh, whose faces are no rectangles. O(n log n) in the edges.
std::vector<FaceEdge> faceEdges(const Fragments& fragments, std::span<const Bond> bonds);

}  // namespace rubble
