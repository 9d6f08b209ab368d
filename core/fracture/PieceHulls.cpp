#include "core/fracture/PieceHulls.h"

#include "core/fracture/ThinPieces.h"
#include "core/geometry/ConvexParts.h"
#include "core/geometry/NumberedCorners.h"
#include "core/geometry/Predicates.h"

#include <glm/geometric.hpp>

namespace rubble {
namespace {

/// True where a corner that turns right does so by no more than rounding.
bool isFlat(Vec2 before, Vec2 corner, Vec2 after, double flat) {
    const Vec2 chord = after - before;
    if (glm::dot(corner - before, chord) < 0.0 || glm::dot(after - corner, chord) < 0.0) return false;
    return std::abs(cross(chord, corner - before)) <= flat * glm::length(chord);
}

bool isNearlyConvex(const Ring& ring, double flat) {
    Vec2 before = ring[ring.size() - 2];
    Vec2 corner = ring[ring.size() - 1];
    for (const Vec2 after : ring) {
        if (orient2d(before, corner, after) < 0 && !isFlat(before, corner, after, flat)) return false;
        before = corner;
        corner = after;
    }
    return true;
}

void addHull(const Ring& ring, double depth, std::vector<Polytope>& hulls) {
    Polytope hull = extruded(ring, -depth / 2.0, depth / 2.0);
    if (!hull.vertices.empty()) hulls.push_back(std::move(hull));
}

}  // namespace

std::vector<Polytope> hullsOfPiece(const Polygon& piece, double depth, const HullTolerance& tolerance) {
    std::vector<Polytope> hulls;
    if (piece.holes.empty() && isNearlyConvex(piece.outer, tolerance.flat)) {
        addHull(piece.outer, depth, hulls);
        return hulls;
    }
    const Result<IndexLoops> parts = convexParts(piece);
    if (!parts) return hulls;
    const std::vector<Vec2> corners = numberedCorners(piece).points;
    for (const std::vector<std::uint32_t>& part : *parts) {
        Ring ring;
        ring.reserve(part.size());
        for (const std::uint32_t corner : part) ring.push_back(corners[corner]);
        if (widthOf(signedArea(ring), perimeter(ring)) > tolerance.thinnest) addHull(ring, depth, hulls);
    }
    return hulls;
}

}  // namespace rubble
