#pragma once

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

/// The area of all pieces of a seed.
inline double areaOfSeed(const Partition& partition, std::uint32_t seed) {
    double sum = 0.0;
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        if (partition.seedOfPiece[piece] == seed) sum += pieceArea(partition, piece);
    }
    return sum;
}

}  // namespace rubble
