#pragma once

#include "core/fracture/voronoi/VoronoiPartition.h"
#include "tests/support/asset/RandomAssets.h"

namespace rubble::test {

/// A random outline (see randomOutline) at a random position, with seeds in its box, some of them clustered around a
/// point.
struct RandomPartition {
    Polygon outline;
    std::vector<Vec2> seeds;
    Partition partition;
};

inline RandomPartition randomPartition(Random& random, int kind, std::uint64_t maxSeeds = 40) {
    RandomPartition made;
    made.outline = withCanonicalWinding(randomOutline(random, kind));
    const Vec2 centre{random.between(-5.0, 5.0), random.between(-5.0, 5.0)};
    for (Vec2& corner : made.outline.outer) corner += centre;
    for (Ring& hole : made.outline.holes) {
        for (Vec2& corner : hole) corner += centre;
    }
    const std::uint64_t count = 1 + random.below(maxSeeds);
    for (std::uint64_t k = 0; k < count; ++k) {
        const double extent = k % 3 == 0 ? 0.1 : 1.0;
        made.seeds.push_back(centre + Vec2{random.between(-extent, extent), random.between(-extent, extent)});
    }
    made.partition = *voronoiPartition(made.outline, made.seeds);
    return made;
}

}  // namespace rubble::test
