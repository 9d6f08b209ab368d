#pragma once

#include "core/fracture/Partition.h"

#include <cmath>
#include <span>
#include <vector>

namespace rubble {

/// How wide an area is: twice its size over its perimeter, which is the width of a long strip, bent or straight.
inline double widthOf(double area, double perimeter) { return 2.0 * area / perimeter; }
double widthOf(const Polygon& polygon);

/// Whether a polygon of this area, whose rings have corners, is wider than `width`. Inline, as a bake asks it of every piece.
inline bool isWider(const Polygon& polygon, double area, double width);

/// The mass of a piece that is too thin for a hull, given to a piece that is not.
struct ThinPieceGift {
    std::uint32_t thin = 0;
    std::uint32_t receiver = kNone;  // kNone: all pieces that can be reached from it are thin
};

/// Who takes the mass of each thin piece: of its neighbours that are not thin the one with the longest shared edge
/// (the first of equals). A thin piece among thin ones gives to where those of its neighbours give that came to a
/// decision in fewer steps, along the longest shared edge again. `thin` names pieces once each; the gifts keep its order.
std::vector<ThinPieceGift> thinPieceGifts(const Partition& partition, std::span<const std::uint32_t> thin);

/// The sentence that tells the user about a gift.
Report thinPieceReport(const Partition& partition, ThinPieceGift gift);

inline bool isWider(const Polygon& polygon, double area, double width) {
    // A side is no longer than its extents in x and y together, which take no root.
    double extents = 0.0;
    const auto addExtents = [&](const Ring& ring) {
        Vec2 from = ring.back();
        for (const Vec2 to : ring) {
            extents += std::abs(to.x - from.x) + std::abs(to.y - from.y);
            from = to;
        }
    };
    addExtents(polygon.outer);
    for (const Ring& hole : polygon.holes) addExtents(hole);
    constexpr double kRoom = 2.0;  // far more than rounding takes
    return widthOf(area, kRoom * extents) > width || widthOf(area, perimeter(polygon)) > width;
}

}  // namespace rubble
