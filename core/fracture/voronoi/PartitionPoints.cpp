#include "core/fracture/voronoi/PartitionPoints.h"

#include "core/base/Parallel.h"

#include <cmath>

namespace rubble {
namespace {

constexpr std::size_t kTrianglesPerPart = 16384;

std::size_t partsOf(const Delaunay& delaunay) {
    return (delaunay.triangles.size() + kTrianglesPerPart - 1) / kTrianglesPerPart;
}

}  // namespace

PointNumbers pointNumbers(const Delaunay& delaunay, const OutlineTrace& trace) {
    PointNumbers numbers;
    numbers.vertices = static_cast<std::uint32_t>(delaunay.triangles.size());
    numbers.crossings = numbers.vertices + static_cast<std::uint32_t>(trace.vertices.size());
    numbers.count = numbers.crossings + static_cast<std::uint32_t>(trace.crossings.size());
    return numbers;
}

void computeCorners(const Delaunay& delaunay, const LocalFrame& frame, int threads, UninitializedVector<Vec2>& points) {
    const Vec2* sites = delaunay.sites.data();
    forEachIndex(partsOf(delaunay), threads, [&](std::size_t part) {
        const IndexRange range = chunkRange(delaunay.triangles.size(), part, partsOf(delaunay));
        for (std::size_t t = range.begin; t < range.end; ++t) {
            const Delaunay::Triangle& triangle = delaunay.triangles[t];
            points[t] = triangle.isGhost() ? Vec2{HUGE_VAL, HUGE_VAL}
                                           : circumcentre(sites[triangle.corner[0]], sites[triangle.corner[1]],
                                                          sites[triangle.corner[2]], frame.origin, frame.extent);
        }
    });
}

void computeOutlinePoints(const Delaunay& delaunay, const OutlineTrace& trace, const LocalFrame& frame,
                          UninitializedVector<Vec2>& points) {
    std::size_t place = delaunay.triangles.size();
    for (const Vec2 vertex : trace.vertices) points[place++] = vertex - frame.origin;
    for (const OutlineCrossing& crossing : trace.crossings) {
        points[place++] =
            intersectionWithBisector(trace.lineOf(crossing), delaunay.sites[delaunay.origin(crossing.halfEdge)],
                                     delaunay.sites[targetOf(delaunay, crossing.halfEdge)], frame.origin, frame.extent);
    }
}

}  // namespace rubble
