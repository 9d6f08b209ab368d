#include "core/fracture/PatternKind.h"
#include "core/fracture/VoronoiPartition.h"

namespace rubble {
namespace {

/// More rounds move seeds by less than anybody sees, and a slip of the finger must not cost an hour.
constexpr std::uint32_t kMostRounds = 1000;

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

std::optional<std::string> parameterFault(const LloydRelaxation& relaxation) {
    if (relaxation.rounds <= kMostRounds) return std::nullopt;
    return "there are " + std::to_string(relaxation.rounds) + " rounds of relaxation, but " +
           std::to_string(kMostRounds) + " is the most";
}

Status applyLayer(const LloydRelaxation& relaxation, const LayerContext& context, SeedSet& seeds) {
    for (std::uint32_t round = 0; round < relaxation.rounds; ++round) {
        const Result<Partition> partition = voronoiPartition(context.outline, seeds.positions, context.task);
        if (!partition) return partition.error();
        for (std::size_t seed = 0; seed < seeds.size(); ++seed) {
            const std::uint32_t piece = partition->pieceOfSeed[seed];
            if (piece != kNone && !seeds.isHeld[seed]) seeds.positions[seed] = centreOfCell(*partition, piece);
        }
    }
    return success();
}

}  // namespace rubble
