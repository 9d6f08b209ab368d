#include "core/fracture/pieces/HullParts.h"

#include "core/fracture/pieces/PieceWidth.h"
#include "core/fracture/pieces/StrictConvexity.h"
#include "core/geometry/polygon/IndexedCorners.h"
#include "core/geometry/predicates/Predicates.h"

#include <glm/geometric.hpp>

namespace rubble {
namespace {

/// Whether a reflex corner is so by no more than rounding.
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

}  // namespace

std::optional<IndexLoops> hullParts(const Polygon& piece, const HullTolerance& tolerance) {
    if (piece.holes.empty() && (isStrictlyConvex(piece.outer) || isNearlyConvex(piece.outer, tolerance.flatness)))
        return IndexLoops{};
    Result<IndexLoops> parts = convexParts(piece);
    if (!parts) return std::nullopt;
    const std::vector<Vec2> corners = indexedCorners(piece).points;
    std::erase_if(*parts, [&](const std::vector<std::uint32_t>& part) {
        Ring ring;
        for (const std::uint32_t corner : part) ring.push_back(corners[corner]);
        return !(widthOf(signedArea(ring), perimeter(ring)) > tolerance.minWidth);
    });
    if (parts->empty()) return std::nullopt;
    return std::move(*parts);
}

}  // namespace rubble
