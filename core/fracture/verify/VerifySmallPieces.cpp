#include "core/fracture/verify/VerifySmallPieces.h"

#include "core/base/MessageText.h"

#include <numeric>
#include <vector>

namespace rubble {
namespace {

constexpr double kAreaRounding = 1e-9;  // of an area: a sum of others is not the area of their union to the last bit

}  // namespace

std::optional<std::string> verifyNoSmallPieces(const Partition& partition, const SmallPieces& small, double depth) {
    const std::vector<double> areas = pieceAreas(partition);
    const double minArea =
        minPieceArea(small, std::accumulate(areas.begin(), areas.end(), 0.0), partition.pieceCount(), depth);
    for (std::uint32_t piece = 0; piece < areas.size() && areas.size() > 1; ++piece) {
        if (areas[piece] >= minArea * (1.0 - kAreaRounding)) continue;
        return "Piece " + std::to_string(piece) + " has " + messageText(areas[piece]) + " m², less than the " +
               messageText(minArea) + " m² that it must have.";
    }
    return std::nullopt;
}

}  // namespace rubble
