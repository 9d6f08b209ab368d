#pragma once

#include "core/base/Random.h"
#include "core/fracture/voronoi/AcuteCorners.h"
#include "core/fracture/voronoi/CellClipper.h"
#include "core/fracture/voronoi/PartitionPoints.h"
#include "core/geometry/polygon/ConvexParts.h"
#include "core/geometry/polygon/HalfPlaneClip.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace rubble::test {

/// The stages of a Voronoi partition up to the clipping of cells.
struct TracedCells {
    TracedCells(Polygon around, const std::vector<Vec2>& seeds)
        : outline(std::move(around)),
          delaunay(*triangulate(seeds)),
          outgoing(outgoingHalfEdges(delaunay)),
          trace(*traceOutline(outline, delaunay, outgoing)),
          frame(localFrame(outline)),
          numbers(pointNumbers(delaunay, trace)),
          acuteCorners(outline, frame) {
        points.resize(numbers.count);
        computeCorners(delaunay, frame, 1, points);
        computeOutlinePoints(delaunay, trace, frame, points);
    }

    std::uint32_t siteCount() const { return static_cast<std::uint32_t>(delaunay.sites.size()); }
    /// The site of an input seed.
    std::uint32_t siteOf(std::uint32_t seed) const {
        return static_cast<std::uint32_t>(std::ranges::find(delaunay.seedOf, seed) - delaunay.seedOf.begin());
    }

    /// The area of a site's cell in the outline, m^2: triangles clipped by the bisectors with all other sites.
    double areaOfCell(std::uint32_t site) const {
        const std::vector<Vec2> corners = cornersOf(outline);
        double sum = 0.0;
        const IndexLoops loops = *triangles(outline);
        for (const std::vector<std::uint32_t>& triangle : loops) {
            Ring part{corners[triangle[0]], corners[triangle[1]], corners[triangle[2]]};
            for (std::uint32_t other = 0; other < siteCount() && !part.empty(); ++other) {
                Ring clipped;
                if (other != site)
                    clipByHalfPlane(part, nearerTo(delaunay.sites[site], delaunay.sites[other]), clipped);
                if (other != site) part = clipped;
            }
            if (!part.empty()) sum += signedArea(part);
        }
        return sum;
    }

    /// The rings of clipped pieces, in the outline's coordinates.
    std::vector<Ring> ringsOf(const CellPieces& pieces) const {
        std::vector<Ring> rings;
        std::uint32_t corner = 0;
        for (const std::uint32_t end : pieces.ringEnds) {
            Ring& ring = rings.emplace_back();
            for (; corner < end; ++corner) ring.push_back(points[pieces.corners[corner].point] + frame.origin);
        }
        return rings;
    }

    Polygon outline;
    Delaunay delaunay;
    std::vector<std::uint32_t> outgoing;
    OutlineTrace trace;
    LocalFrame frame;
    PointNumbers numbers;
    AcuteCorners acuteCorners;
    UninitializedVector<Vec2> points;
};

/// Two to `most` seeds around an outline of 8 x 8 m; on a lattice, many of them are cocircular with others.
inline std::vector<Vec2> randomSeeds(Random& random, std::uint64_t most, bool isOnLattice) {
    std::vector<Vec2> seeds{{4.0, 4.0}, {-1.0, 3.0}};
    const std::uint64_t count = random.below(most - 1);
    for (std::uint64_t k = 0; k < count; ++k) {
        seeds.push_back(isOnLattice ? Vec2(static_cast<double>(random.below(9)), static_cast<double>(random.below(9)))
                                    : Vec2(random.between(-1.0, 9.0), random.between(-1.0, 9.0)));
    }
    return seeds;
}

}  // namespace rubble::test
