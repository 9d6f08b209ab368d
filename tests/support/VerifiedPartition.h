#pragma once

#include "core/fracture/Grain.h"
#include "core/fracture/PatternPartition.h"
#include "core/fracture/Prism.h"
#include "core/fracture/Verify.h"
#include "core/fracture/VoronoiPartition.h"

#include <span>

namespace rubble {

/// The whole public way from an outline and seeds to the partition, each stage verified. A fault that a verify
/// function finds comes back as an error that begins with the function's name.
inline Result<Partition> verifiedPartition(const Polygon& outline, std::span<const Vec2> seeds) {
    const auto fault = [](const char* function, const std::string& sentence) {
        return Error{ErrorCode::Degenerate, std::string(function) + ": " + sentence};
    };
    const Result<Prism> prism = validated(Prism{outline, 1.0});
    if (!prism) return prism.error();
    const Result<Delaunay> delaunay = triangulate(seeds);
    if (!delaunay) return delaunay.error();
    if (const auto wrong = verifyDelaunay(*delaunay, seeds)) return fault("verifyDelaunay", *wrong);
    const Result<Partition> partition = voronoiPartition(prism->outline, *delaunay);
    if (!partition) return partition.error();
    if (const auto wrong = verifyPartition(*partition, prism->outline)) return fault("verifyPartition", *wrong);
    if (const auto wrong = verifyNearestSeed(*partition, seeds)) return fault("verifyNearestSeed", *wrong);
    return partition;
}

/// The whole way of a pattern on an outline, each stage verified.
inline Result<PatternStages> verifiedStages(const Pattern& pattern, const Polygon& outline) {
    const auto fault = [](const char* function, const std::string& sentence) {
        return Error{ErrorCode::Degenerate, std::string(function) + ": " + sentence};
    };
    const Result<Prism> prism = validated(Prism{outline, 1.0});
    if (!prism) return prism.error();
    const Result<PatternStages> stages = partitionBy(pattern, prism->outline);
    if (!stages) return stages.error();
    const Partition& partition = stages->partition;
    const std::optional<GrainMap> grain = GrainMap::of(pattern, prism->outline);
    const std::vector<Vec2> seeds =
        grain ? (*grain)(std::span<const Vec2>(stages->seeds.positions)) : stages->seeds.positions;
    if (const auto wrong = verifyDelaunay(stages->delaunay, seeds)) return fault("verifyDelaunay", *wrong);
    if (const auto wrong = verifyPartition(partition, prism->outline)) return fault("verifyPartition", *wrong);
    if (const auto wrong = verifyNearestSeed(grain ? (*grain)(partition) : partition, seeds))
        return fault("verifyNearestSeed", *wrong);
    return stages;
}

/// The area of all pieces of a seed.
inline double areaOfSeed(const Partition& partition, std::uint32_t seed) {
    double sum = 0.0;
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        if (partition.seedOfPiece[piece] == seed) sum += pieceArea(partition, piece);
    }
    return sum;
}

}  // namespace rubble
