#include "core/fracture/kinds/LloydRelaxation.h"

#include "core/fracture/kinds/Relaxation.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"

namespace rubble {
namespace {

constexpr std::array kLloydRelaxationParameters{
    parameter<&LloydRelaxation::rounds>(
        {.name = "rounds",
         .caption = "Rounds",
         .hint = "Number of times that the seeds above move to the centroids of their cells",
         .range = {0.0, kMaxRelaxationRounds},
         .sliderRange = {0.0, 20.0}}),
};

/// The centroid of all pieces of one seed, which begin at `piece`.
Vec2 centroidOfCell(const Partition& partition, std::uint32_t piece) {
    const std::uint32_t seed = partition.seedOfPiece[piece];
    Vec2 moment{0.0, 0.0};
    double total = 0.0;
    for (; piece < partition.pieceCount() && partition.seedOfPiece[piece] == seed; ++piece) {
        const Polygon outline = pieceOutline(partition, piece);
        const double pieceArea = area(outline);
        moment += pieceArea * centroid(outline);
        total += pieceArea;
    }
    return partition.origin + moment / total;
}

}  // namespace

constinit const LayerKind LloydRelaxation::kKind{.name = "lloyd",
                                                 .caption = "Lloyd relaxation",
                                                 .hint = "Evens out the layers above",
                                                 .icon = "layer-lloyd",
                                                 .summary = "{rounds|1 round|%1 rounds}",
                                                 .role = LayerRole::Moves,
                                                 .parameters = kLloydRelaxationParameters};

Status LloydRelaxation::apply(const LayerContext& context, SeedSet& seeds) const {
    return relax(rounds, context, seeds, [](const Partition& partition, std::uint32_t piece, Vec2) {
        return centroidOfCell(partition, piece);
    });
}

Status LloydRelaxation::applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const {
    return relaxInSolid(rounds, context, seeds);
}

}  // namespace rubble
