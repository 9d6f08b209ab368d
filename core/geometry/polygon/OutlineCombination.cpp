#include "core/geometry/polygon/OutlineCombination.h"

#include "core/base/MessageText.h"
#include "core/geometry/polygon/NarrowFeatures.h"
#include "core/geometry/polygon/OutlineCleaning.h"
#include "core/geometry/polygon/PolygonBoolean.h"
#include "core/geometry/polygon/PolygonFaults.h"
#include "core/geometry/predicates/SegmentDistance.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>

namespace rubble {
namespace {

constexpr std::size_t kNoCorner = std::numeric_limits<std::size_t>::max();

struct IsLess {
    bool operator()(Vec2 a, Vec2 b) const { return lexicographicLess(a, b); }
};

template <class Visit>
void forEachRing(Polygon& polygon, Visit visit) {
    visit(polygon.outer);
    for (Ring& ring : polygon.holes) visit(ring);
}

/// Moves the corners of a ring that are within a distance of these corners onto them.
void snapToCorners(Ring& ring, std::span<const Vec2> corners, double distance) {
    for (Vec2& point : ring) {
        const auto nearest =
            std::ranges::min_element(corners, {}, [&](Vec2 corner) { return glm::distance(corner, point); });
        if (glm::distance(*nearest, point) <= distance) point = *nearest;
    }
}

/// Inserts those of the points within a distance of an edge of the ring into the edge, unless they are its corners.
void insertNearPoints(Ring& ring, std::span<const Vec2> points, double distance) {
    Ring inserted;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 from = ring[k], to = ring[(k + 1) % ring.size()];
        std::vector<Vec2> onEdge;
        for (const Vec2 point : points) {
            if (point != from && point != to && distanceToSegment(point, from, to) <= distance) onEdge.push_back(point);
        }
        std::ranges::sort(onEdge, {}, [&](Vec2 point) { return closestFraction(point, from, to); });
        inserted.push_back(from);
        inserted.insert(inserted.end(), onEdge.begin(), onEdge.end());
    }
    ring = std::move(inserted);
}

/// Numbers the corners of an outline; whether each lies on a straight line with its neighbours.
class OriginalCorners {
public:
    OriginalCorners(Polygon outline, double tolerance) : m_tolerance(tolerance) {
        forEachRing(outline, [&](const Ring& ring) {
            for (std::size_t k = 0; k < ring.size(); ++k)
                m_corners.emplace(ring[k], Corner{m_corners.size(), isStraightAt(ring, k)});
        });
    }

    std::size_t numberOf(Vec2 point) const {
        const auto found = m_corners.find(point);
        return found == m_corners.end() ? kNoCorner : found->second.number;
    }
    /// Removes the corners of straight runs that were none of the outline.
    void removeNewStraightCorners(Ring& ring) const {
        for (std::size_t k = 0; k < ring.size();) {
            const auto found = m_corners.find(ring[k]);
            const bool wasStraight = found != m_corners.end() && found->second.isStraight;
            if (ring.size() > 3 && !wasStraight && isStraightAt(ring, k)) {
                ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(k));
                if (k > 0) --k;
            } else {
                ++k;
            }
        }
    }
    /// Starts each ring at its first corner of the outline, or at its smallest if it has none; sorts the holes by it.
    void restoreOrder(Polygon& polygon) const {
        const auto key = [&](Vec2 point) { return std::tuple(numberOf(point), point.x, point.y); };
        forEachRing(polygon, [&](Ring& ring) { std::ranges::rotate(ring, std::ranges::min_element(ring, {}, key)); });
        std::ranges::sort(polygon.holes, {}, [&](const Ring& ring) { return key(ring[0]); });
    }

private:
    struct Corner {
        std::size_t number;
        bool isStraight;
    };
    bool isStraightAt(const Ring& ring, std::size_t k) const {
        const Vec2 before = ring[(k + ring.size() - 1) % ring.size()], after = ring[(k + 1) % ring.size()];
        return distanceToSegment(ring[k], before, after) <= m_tolerance;
    }

    double m_tolerance;
    std::map<Vec2, Corner, IsLess> m_corners;
};

Error partsError(std::size_t parts, OutlineOperation operation) {
    if (operation == OutlineOperation::Add)
        return {ErrorCode::Degenerate, "The shape does not overlap the outline: draw it across the border."};
    return {ErrorCode::Degenerate, "The cut would divide the outline into " + std::to_string(parts) +
                                       " parts: draw it so that one part remains."};
}

Error unchangedError(OutlineOperation operation) {
    return {ErrorCode::Degenerate, operation == OutlineOperation::Add
                                       ? "The shape lies within the outline: there is nothing to add."
                                       : "The shape lies outside the outline: there is nothing to cut."};
}

Error touchingError(const PolygonFault& fault) {
    constexpr int kDigits = 6;
    const std::string where = "(" + roundedText(fault.where.x, kDigits) + ", " + roundedText(fault.where.y, kDigits);
    return {ErrorCode::Degenerate, "The outline would touch itself at " + where +
                                       "): move the shape so that it crosses the border there or keeps clear of it."};
}

}  // namespace

Result<Polygon> combined(const Polygon& outline, const Ring& shape, OutlineOperation operation) {
    Result<Polygon> drawn = validated(Polygon{shape, {}});
    if (!drawn) return drawn.error();
    const double tolerance = kVisibleFraction * boundsOf(outline.outer).diagonal();
    const std::vector<Vec2> corners = cornersOf(outline);
    Ring area = drawn->outer;
    snapToCorners(area, corners, tolerance);
    removeRepeatedPoints(area);
    Polygon base = outline;
    forEachRing(base, [&](Ring& ring) { insertNearPoints(ring, area, tolerance); });
    insertNearPoints(area, corners, tolerance);

    std::vector<Ring> rings =
        operation == OutlineOperation::Add ? unionBoundary(base, area) : differenceBoundary(base, area);
    std::erase_if(rings, [&](const Ring& ring) { return std::abs(signedArea(ring)) <= tolerance * perimeter(ring); });
    const auto holes = std::ranges::partition(rings, [](const Ring& ring) { return signedArea(ring) > 0.0; });
    const auto parts = static_cast<std::size_t>(holes.begin() - rings.begin());
    if (parts == 0) return Error{ErrorCode::Degenerate, "The shape covers the whole outline: nothing would remain."};
    if (parts > 1) return partsError(parts, operation);
    Polygon result{std::move(rings[0]), {holes.begin(), holes.end()}};
    const OriginalCorners original(outline, tolerance);
    forEachRing(result, [&](Ring& ring) { original.removeNewStraightCorners(ring); });
    original.restoreOrder(result);

    Polygon before = outline;
    original.restoreOrder(before);
    if (result == before) return unchangedError(operation);
    if (const std::vector<PolygonFault> faults = polygonFaults(result, 1); !faults.empty())
        return touchingError(faults[0]);
    if (const std::optional<PolygonFault> narrow = narrowFault(result)) return touchingError(*narrow);
    return result;
}

}  // namespace rubble
