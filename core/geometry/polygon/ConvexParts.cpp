#include "core/geometry/polygon/ConvexParts.h"

#include "core/geometry/polygon/HalfEdgeTriangles.h"
#include "core/geometry/polygon/PolygonFaults.h"
#include "core/geometry/polygon/RingArrangement.h"
#include "core/geometry/polygon/TouchingCorners.h"
#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace rubble {

namespace {

/// Whether the sweeps accept the corners: exactly usable, and no two consecutive ones equal.
bool areSweepable(const IndexedCorners& corners) {
    if (corners.points.empty()) return false;
    for (std::uint32_t corner = 0; corner < corners.cornerCount(); ++corner)
        if (!isExactlyUsable(corners.points[corner]) || corners.points[corner] == corners.points[corners.next[corner]])
            return false;
    return true;
}

std::optional<HalfEdgeTriangles> delaunayTriangles(const Polygon& polygon) {
    IndexedCorners corners = indexedCorners(polygon);
    if (!areSweepable(corners) || ringArrangement(corners, 1).hasEdgeIntersection || !splitTouchingCorners(corners))
        return std::nullopt;
    const std::optional<std::vector<CornerTriangle>> swept = sweepTriangulation(corners);
    if (!swept) return std::nullopt;
    std::optional<HalfEdgeTriangles> triangles = linkTriangles(*swept, corners);
    if (triangles) makeDelaunay(*triangles, corners.points);
    return triangles;
}

Error invalidPolygon(const Polygon& polygon) {
    const std::vector<PolygonFault> faults = polygonFaults(polygon, 1);
    const std::string reason = faults.empty() ? "The winding of its rings is reversed." : faults[0].message;
    return {ErrorCode::Crossing, "The polygon cannot be decomposed into convex parts. " + reason};
}

/// The faces that remain when edges are removed from a triangulation.
struct Faces {
    explicit Faces(const HalfEdgeTriangles& triangles)
        : next(triangles.origin.size()), previous(triangles.origin.size()), isRemoved(triangles.origin.size()) {
        for (std::uint32_t halfEdge = 0; halfEdge < triangles.halfEdgeCount(); ++halfEdge) {
            next[halfEdge] = HalfEdgeTriangles::next(halfEdge);
            previous[halfEdge] = HalfEdgeTriangles::previous(halfEdge);
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

/// Removes every diagonal whose removal leaves both its ends convex.
void removeInessentialDiagonals(Faces& faces, const HalfEdgeTriangles& triangles, std::span<const Vec2> points) {
    const auto point = [&](std::uint32_t halfEdge) { return points[triangles.origin[halfEdge]]; };
    // The corner at the start of a half-edge, after its face is merged with its twin's.
    const auto staysConvex = [&](std::uint32_t halfEdge, std::uint32_t twin) {
        return orient2d(point(faces.previous[halfEdge]), point(halfEdge), point(faces.next[faces.next[twin]])) >= 0;
    };
    for (std::uint32_t halfEdge = 0; halfEdge < triangles.halfEdgeCount(); ++halfEdge) {
        const std::uint32_t twin = triangles.twin[halfEdge];
        if (twin == kNone || twin < halfEdge) continue;
        if (staysConvex(halfEdge, twin) && staysConvex(twin, halfEdge)) faces.remove(halfEdge, twin);
    }
}

/// Every face as a loop starting at its lowest index, sorted.
IndexLoops loopsOf(const Faces& faces, const HalfEdgeTriangles& triangles) {
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

/// The Delaunay triangulation of a convex ring, equal to that of makeDelaunay(): the triangle to the left of an edge or
/// diagonal is that of the corner whose circumcircle with its ends is empty. O(n^2), which is faster for few corners.
class ConvexTriangulation {
public:
    explicit ConvexTriangulation(std::span<const Vec2> ring) : m_ring(ring) {}

    /// Nothing if four corners are cocircular or three collinear: then it is not unique.
    std::optional<IndexLoops> triangles() {
        m_triangles.reserve(m_ring.size() - 2);
        if (!triangulate(0, static_cast<std::uint32_t>(m_ring.size()) - 1)) return std::nullopt;
        std::ranges::sort(m_triangles);
        return std::move(m_triangles);
    }

private:
    /// Triangulates the corners from first to last, to the right of the diagonal between these.
    bool triangulate(std::uint32_t first, std::uint32_t last) {
        if (last - first < 2) return true;
        std::uint32_t apex = first + 1;
        for (std::uint32_t corner = first + 2; corner < last; ++corner) {
            const int side = inCircle(m_ring[first], m_ring[apex], m_ring[last], m_ring[corner]);
            if (side == 0) return false;
            if (side > 0) apex = corner;
        }
        if (orient2d(m_ring[first], m_ring[apex], m_ring[last]) == 0) return false;
        m_triangles.push_back({first, apex, last});
        return triangulate(first, apex) && triangulate(apex, last);
    }

    std::span<const Vec2> m_ring;
    IndexLoops m_triangles;
};

constexpr std::size_t kMaxSimpleCorners = 24;

}  // namespace

Result<IndexLoops> triangles(const Polygon& polygon) {
    if (polygon.holes.empty() && polygon.outer.size() <= kMaxSimpleCorners && isSimpleAndConvex(polygon.outer)) {
        if (std::optional<IndexLoops> found = ConvexTriangulation(polygon.outer).triangles()) return std::move(*found);
    }
    const std::optional<HalfEdgeTriangles> halfEdges = delaunayTriangles(polygon);
    if (!halfEdges) return invalidPolygon(polygon);
    return loopsOf(Faces(*halfEdges), *halfEdges);
}

Result<IndexLoops> convexParts(const Polygon& polygon) {
    if (polygon.holes.empty() && isSimpleAndConvex(polygon.outer)) {
        IndexLoops whole(1, std::vector<std::uint32_t>(polygon.outer.size()));
        std::iota(whole[0].begin(), whole[0].end(), 0u);
        return whole;
    }
    const std::optional<HalfEdgeTriangles> halfEdges = delaunayTriangles(polygon);
    if (!halfEdges) return invalidPolygon(polygon);
    Faces faces(*halfEdges);
    removeInessentialDiagonals(faces, *halfEdges, indexedCorners(polygon).points);
    return loopsOf(faces, *halfEdges);
}

}  // namespace rubble
