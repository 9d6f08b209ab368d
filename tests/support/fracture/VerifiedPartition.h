#pragma once

#include "core/fracture/pattern/AnisotropyMap.h"
#include "core/fracture/pattern/PatternPartition.h"
#include "core/fracture/pieces/Prism.h"
#include "core/fracture/verify/VerifyDelaunay.h"
#include "core/fracture/verify/VerifyNearestSeed.h"
#include "core/fracture/verify/VerifyPartition.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "tests/support/ErrorText.h"

#include <span>
#include <string>
#include <vector>

namespace rubble {

/// The partition of an outline by seeds, with every stage verified. A fault found by a verify function is returned as
/// an error that starts with the function's name.
inline Result<Partition> verifiedPartition(const Polygon& outline, std::span<const Vec2> seeds) {
    const auto error = [](const char* function, const std::string& sentence) {
        return Error{ErrorCode::Degenerate, std::string(function) + ": " + sentence};
    };
    const Result<Prism> prism = validated(Prism{outline, 1.0});
    if (!prism) return prism.error();
    const Result<Delaunay> delaunay = triangulate(seeds);
    if (!delaunay) return delaunay.error();
    if (const auto fault = verifyDelaunay(*delaunay, seeds)) return error("verifyDelaunay", *fault);
    const Result<Partition> partition = voronoiPartition(prism->outline, *delaunay);
    if (!partition) return partition.error();
    if (const auto fault = verifyPartition(*partition, prism->outline)) return error("verifyPartition", *fault);
    if (const auto fault = verifyNearestSeed(*partition, seeds)) return error("verifyNearestSeed", *fault);
    return partition;
}

/// The error of verifiedPartition(); empty if there is none.
inline std::string partitionFault(const Polygon& outline, const std::vector<Vec2>& seeds) {
    return errorText(verifiedPartition(outline, seeds));
}

/// The stages of a pattern on an outline, each verified.
inline Result<PatternStages> verifiedStages(const Pattern& pattern, const Polygon& outline) {
    const auto error = [](const char* function, const std::string& sentence) {
        return Error{ErrorCode::Degenerate, std::string(function) + ": " + sentence};
    };
    const Result<Prism> prism = validated(Prism{outline, 1.0});
    if (!prism) return prism.error();
    const Result<PatternStages> stages = patternStages(pattern, prism->outline);
    if (!stages) return stages.error();
    const Partition& partition = stages->partition;
    const std::optional<AnisotropyMap> grain = AnisotropyMap::of(pattern, prism->outline);
    const std::vector<Vec2> seeds =
        grain ? (*grain)(std::span<const Vec2>(stages->seeds.positions)) : stages->seeds.positions;
    if (const auto fault = verifyDelaunay(stages->delaunay, seeds)) return error("verifyDelaunay", *fault);
    if (const auto fault = verifyPartition(partition, prism->outline)) return error("verifyPartition", *fault);
    if (const auto fault = verifyNearestSeed(grain ? (*grain)(partition) : partition, seeds))
        return error("verifyNearestSeed", *fault);
    return stages;
}

/// The total area of the pieces of a seed.
inline double areaOfSeed(const Partition& partition, std::uint32_t seed) {
    double sum = 0.0;
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        if (partition.seedOfPiece[piece] == seed) sum += pieceArea(partition, piece);
    }
    return sum;
}

}  // namespace rubble
