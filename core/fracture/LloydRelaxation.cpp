#include "core/fracture/PatternKind.h"
#include "core/fracture/PatternPartition.h"

namespace rubble {
namespace {

/// More rounds move seeds by less than anybody sees, and a slip of the finger must not cost an hour.
constexpr std::uint32_t kMostRounds = 1000;

constexpr std::array kParameters{
    parameter<&LloydRelaxation::rounds>(
        {.name = "rounds",
         .caption = "Rounds",
         .hint = "How often the seeds above move to the middle of their cells: more make cells even",
         .range = {0.0, kMostRounds},
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
    const Pattern none;
    for (std::uint32_t round = 0; round < rounds; ++round) {
        if (context.task.isCancelled()) return TaskContext::cancelled();
        const Result<CutCells> cells =
            cellsOf(context.pattern ? *context.pattern : none, seeds.positions, context.outline, context.task);
        if (!cells) return cells.error();
        for (std::size_t seed = 0; seed < seeds.size(); ++seed) {
            const std::uint32_t piece = cells->partition.pieceOfSeed[seed];
            if (piece != kNone && !seeds.isHeld[seed]) seeds.positions[seed] = centreOfCell(cells->partition, piece);
        }
    }
    return success();
}

}  // namespace rubble
