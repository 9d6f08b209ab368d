#pragma once

#include "core/fracture/VoronoiPartition.h"
#include "tests/support/RandomAssets.h"

namespace rubble::test {

/// An outline of some kind (see randomOutline), moved about, with seeds in its box, some of them crowded around a point.
struct RandomPartition {
    Polygon outline;
    std::vector<Vec2> seeds;
    Partition partition;
};

inline RandomPartition randomPartition(Random& random, int kind, std::uint64_t mostSeeds = 40) {
    RandomPartition made;
    made.outline = withCanonicalWinding(randomOutline(random, kind));
    const Vec2 moved{random.between(-5.0, 5.0), random.between(-5.0, 5.0)};
    for (Vec2& corner : made.outline.outer) corner += moved;
    for (Ring& hole : made.outline.holes) {
        for (Vec2& corner : hole) corner += moved;
    }
    const std::uint64_t count = 1 + random.below(mostSeeds);
    for (std::uint64_t k = 0; k < count; ++k) {
        const double reach = k % 3 == 0 ? 0.1 : 1.0;
        made.seeds.push_back(moved + Vec2{random.between(-reach, reach), random.between(-reach, reach)});
    }
    made.partition = *voronoiPartition(made.outline, made.seeds);
    return made;
}

}  // namespace rubble::test
