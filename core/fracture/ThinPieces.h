#pragma once

#include "core/fracture/Partition.h"

#include <span>
#include <vector>

namespace rubble {

/// How wide an area is: twice its size over its perimeter, which is the width of a long strip, bent or straight.
double widthOf(double area, double perimeter);
double widthOf(const Polygon& polygon);

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

}  // namespace rubble
