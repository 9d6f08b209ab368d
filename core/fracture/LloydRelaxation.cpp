#include "core/fracture/LloydRelaxation.h"

#include "core/fracture/PatternKind.h"
#include "core/fracture/Relaxation.h"

namespace rubble {
namespace {

constexpr std::array kParameters{
    parameter<&LloydRelaxation::rounds>(
        {.name = "rounds",
         .caption = "Rounds",
         .hint = "How often the seeds above move to the middle of their cells: more make cells even",
         .range = {0.0, kMostRelaxationRounds},
         .usual = {0.0, 20.0}}),
};

/// The centre of area of all pieces of one seed, which begin at `piece`.
Vec2 centreOfCell(const Partition& partition, std::uint32_t piece) {
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

constinit const PatternKind LloydRelaxation::kKind{
    .name = "lloyd",
    .caption = "Lloyd relaxation",
    .hint = "Evens out the layers above",
    .role = LayerRole::Moves,
    .parameters = kParameters,
    .suitedTo = [](const Box2&) -> LayerParameters { return LloydRelaxation{}; }};

Status LloydRelaxation::apply(const LayerContext& context, SeedSet& seeds) const {
    return relax(rounds, context, seeds,
                 [](const Partition& partition, std::uint32_t piece, Vec2) { return centreOfCell(partition, piece); });
}

}  // namespace rubble
