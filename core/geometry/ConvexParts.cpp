#include "core/geometry/ConvexParts.h"

#include "core/geometry/CornerSectors.h"
#include "core/geometry/EdgeSweep.h"
#include "core/geometry/LinkedTriangles.h"
#include "core/geometry/PolygonFaults.h"
#include "core/geometry/Predicates.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace rubble {

namespace {

/// True where a sweep can look at the corners: usable, and no two neighbours equal.
bool areSweepable(const NumberedCorners& corners) {
    if (corners.points.empty()) return false;
    for (std::uint32_t corner = 0; corner < corners.cornerCount(); ++corner)
        if (!isExactlyUsable(corners.points[corner]) || corners.points[corner] == corners.points[corners.next[corner]])
            return false;
    return true;
}

std::optional<LinkedTriangles> delaunayTriangles(const Polygon& polygon) {
    NumberedCorners corners = numberedCorners(polygon);
    if (!areSweepable(corners) || arrangementOf(corners, 1).doEdgesCollide || !partSectors(corners))
        return std::nullopt;
    const std::optional<std::vector<CornerTriangle>> swept = sweptTriangles(corners);
    if (!swept) return std::nullopt;
    std::optional<LinkedTriangles> triangles = linked(*swept, corners);
    if (triangles) makeDelaunay(*triangles, corners.points);
    return triangles;
}

Error notCuttable(const Polygon& polygon) {
    const std::vector<PolygonFault> faults = polygonFaults(polygon, 1);
    const std::string reason = faults.empty() ? "Its rings run the wrong way round." : faults[0].message;
    return {ErrorCode::Crossing, "The polygon cannot be cut into convex parts. " + reason};
}

/// The faces that are left when half-edges are taken out of triangles.
struct Faces {
    explicit Faces(const LinkedTriangles& triangles)
        : next(triangles.origin.size()), previous(triangles.origin.size()), isRemoved(triangles.origin.size()) {
        for (std::uint32_t halfEdge = 0; halfEdge < triangles.halfEdgeCount(); ++halfEdge) {
            next[halfEdge] = LinkedTriangles::next(halfEdge);
            previous[halfEdge] = LinkedTriangles::previous(halfEdge);
        }
    }
    void remove(std::uint32_t halfEdge, std::uint32_t twin) {
        join(previous[halfEdge], next[twin]);
        join(previous[twin], next[halfEdge]);
        isRemoved[halfEdge] = isRemoved[twin] = true;
    }
    void join(std::uint32_t first, std::uint32_t second) {
        next[first] = second;
        previous[second] = first;
    }

    std::vector<std::uint32_t> next;
    std::vector<std::uint32_t> previous;
    std::vector<bool> isRemoved;
};

/// Takes out every inner edge that leaves both its ends convex.
void removeNeedlessDiagonals(Faces& faces, const LinkedTriangles& triangles, std::span<const Vec2> points) {
    const auto point = [&](std::uint32_t halfEdge) { return points[triangles.origin[halfEdge]]; };
    // The corner at the start of a half-edge as it will be when its twin's face has been joined.
    const auto staysConvex = [&](std::uint32_t halfEdge, std::uint32_t twin) {
        return orient2d(point(faces.previous[halfEdge]), point(halfEdge), point(faces.next[faces.next[twin]])) >= 0;
    };
    for (std::uint32_t halfEdge = 0; halfEdge < triangles.halfEdgeCount(); ++halfEdge) {
        const std::uint32_t twin = triangles.twin[halfEdge];
        if (twin == LinkedTriangles::kBoundary || twin < halfEdge) continue;
        if (staysConvex(halfEdge, twin) && staysConvex(twin, halfEdge)) faces.remove(halfEdge, twin);
    }
}

/// Every face as a loop from its lowest corner, in ascending order.
IndexLoops loopsOf(const Faces& faces, const LinkedTriangles& triangles) {
    IndexLoops loops;
    std::vector<bool> isDone = faces.isRemoved;
    for (std::uint32_t first = 0; first < triangles.halfEdgeCount(); ++first) {
        if (isDone[first]) continue;
        std::vector<std::uint32_t>& loop = loops.emplace_back();
        for (std::uint32_t halfEdge = first; !isDone[halfEdge]; halfEdge = faces.next[halfEdge]) {
            loop.push_back(triangles.origin[halfEdge]);
            isDone[halfEdge] = true;
        }
        std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    }
    std::sort(loops.begin(), loops.end());
    return loops;
}

/// The triangulation that makeDelaunay() comes to, for a convex ring, whose edges and diagonals each have one Delaunay triangle on
/// their left: that of the corner whose circle through their ends holds no other. O(n^2), which is quicker for few corners.
class ConvexTriangulation {
public:
    explicit ConvexTriangulation(std::span<const Vec2> ring) : m_ring(ring) {}

    /// None where four corners lie on a circle or three on a line: then it is not the only one.
    std::optional<IndexLoops> triangles() {
        m_triangles.reserve(m_ring.size() - 2);
        if (!cutOff(0, static_cast<std::uint32_t>(m_ring.size()) - 1)) return std::nullopt;
        std::ranges::sort(m_triangles);
        return std::move(m_triangles);
    }

private:
    /// The corners from first to last, beyond the diagonal between these.
    bool cutOff(std::uint32_t first, std::uint32_t last) {
        if (last - first < 2) return true;
        std::uint32_t apex = first + 1;
        for (std::uint32_t corner = first + 2; corner < last; ++corner) {
            const int side = inCircle(m_ring[first], m_ring[apex], m_ring[last], m_ring[corner]);
            if (side == 0) return false;
            if (side > 0) apex = corner;
        }
        if (orient2d(m_ring[first], m_ring[apex], m_ring[last]) == 0) return false;
        m_triangles.push_back({first, apex, last});
        return cutOff(first, apex) && cutOff(apex, last);
    }

    std::span<const Vec2> m_ring;
    IndexLoops m_triangles;
};

constexpr std::size_t kFewCorners = 24;

}  // namespace

Result<IndexLoops> triangles(const Polygon& polygon) {
    if (polygon.holes.empty() && polygon.outer.size() <= kFewCorners && isSimpleAndConvex(polygon.outer)) {
        if (std::optional<IndexLoops> found = ConvexTriangulation(polygon.outer).triangles()) return std::move(*found);
    }
    const std::optional<LinkedTriangles> linkedTriangles = delaunayTriangles(polygon);
    if (!linkedTriangles) return notCuttable(polygon);
    return loopsOf(Faces(*linkedTriangles), *linkedTriangles);
}

Result<IndexLoops> convexParts(const Polygon& polygon) {
    if (polygon.holes.empty() && isSimpleAndConvex(polygon.outer)) {
        IndexLoops whole(1, std::vector<std::uint32_t>(polygon.outer.size()));
        std::iota(whole[0].begin(), whole[0].end(), 0u);
        return whole;
    }
    const std::optional<LinkedTriangles> linkedTriangles = delaunayTriangles(polygon);
    if (!linkedTriangles) return notCuttable(polygon);
    Faces faces(*linkedTriangles);
    removeNeedlessDiagonals(faces, *linkedTriangles, numberedCorners(polygon).points);
    return loopsOf(faces, *linkedTriangles);
}

}  // namespace rubble
