#include "core/geometry/polygon/PolygonBoolean.h"

#include <clipper.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace rubble {
namespace {

constexpr double kClipperRange = 0x1p48;          // Clipper works on integers
constexpr double kMaxClipperCoordinate = 0x1p12;  // relative to the extent; farther points are clamped

/// Converts points to integers and back, the polygon's own corners to their exact bits.
class Lattice {
public:
    explicit Lattice(const Box2& box)
        : m_middle(box.min + box.size() / 2.0), m_scale(kClipperRange / std::max(box.size().x, box.size().y)) {}

    ClipperLib::Path path(const Ring& ring) const {
        ClipperLib::Path path;
        for (const Vec2 point : ring) path.push_back(at(point));
        return path;
    }
    void keep(const Ring& ring) {
        for (const Vec2 point : ring) m_kept.emplace(std::array{at(point).X, at(point).Y}, point);
    }
    /// Also for new corners with one of their coordinates.
    void keepCoordinates(const Ring& ring) {
        for (const Vec2 point : ring) {
            m_keptX.emplace(at(point).X, point.x);
            m_keptY.emplace(at(point).Y, point.y);
        }
    }
    Ring ring(const ClipperLib::Path& path) const {
        Ring ring;
        for (const ClipperLib::IntPoint point : path) {
            const auto kept = m_kept.find({point.X, point.Y});
            ring.push_back(kept != m_kept.end() ? kept->second : newCorner(point));
        }
        return ring;
    }

private:
    ClipperLib::IntPoint at(Vec2 point) const {
        const Vec2 numbers = glm::clamp((point - m_middle) * m_scale, -kMaxClipperCoordinate * kClipperRange,
                                        kMaxClipperCoordinate * kClipperRange);
        return {std::llround(numbers.x), std::llround(numbers.y)};
    }
    Vec2 newCorner(ClipperLib::IntPoint point) const {
        const Vec2 corner = m_middle + Vec2(static_cast<double>(point.X), static_cast<double>(point.Y)) / m_scale;
        const auto x = m_keptX.find(point.X), y = m_keptY.find(point.Y);
        return {x != m_keptX.end() ? x->second : corner.x, y != m_keptY.end() ? y->second : corner.y};
    }

    Vec2 m_middle;
    double m_scale;
    std::map<std::array<ClipperLib::cInt, 2>, Vec2> m_kept;
    std::map<ClipperLib::cInt, double> m_keptX, m_keptY;
};

void addSubject(const Polygon& polygon, Lattice& lattice, ClipperLib::Clipper& clipper) {
    clipper.StrictlySimple(true);
    lattice.keep(polygon.outer);
    clipper.AddPath(lattice.path(polygon.outer), ClipperLib::ptSubject, true);
    for (const Ring& hole : polygon.holes) {
        lattice.keep(hole);
        clipper.AddPath(lattice.path(hole), ClipperLib::ptSubject, true);
    }
}

struct IsBefore {
    bool operator()(Vec2 a, Vec2 b) const { return lexicographicLess(a, b); }
};

/// Rings of the same area without the edges that they run along in both directions: Clipper leaves holes that share an
/// edge with their outline as they are.
std::vector<Ring> withoutOpposites(const std::vector<Ring>& rings) {
    std::map<Vec2, std::vector<Vec2>, IsBefore> edges;  // by their start
    for (const Ring& ring : rings) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Vec2 from = ring[k], to = ring[(k + 1) % ring.size()];
            std::vector<Vec2>& back = edges[to];
            const auto opposite = std::ranges::find(back, from);
            if (opposite != back.end()) {
                back.erase(opposite);
            } else {
                edges[from].push_back(to);
            }
        }
    }
    std::vector<Ring> traced;
    for (auto& [start, ends] : edges) {
        while (!ends.empty()) {
            Ring& ring = traced.emplace_back();
            Vec2 at = start;
            do {
                ring.push_back(at);
                std::vector<Vec2>& next = edges[at];
                at = next.back();
                next.pop_back();
            } while (at != start);
        }
    }
    return traced;
}

std::vector<Ring> boundary(const Polygon& polygon, const Ring& area, ClipperLib::ClipType operation) {
    Lattice lattice(boundsOf(polygon.outer));
    ClipperLib::Clipper clipper;
    clipper.PreserveCollinear(true);
    addSubject(polygon, lattice, clipper);
    lattice.keep(area);
    for (const Ring& corners : {cornersOf(polygon), area}) lattice.keepCoordinates(corners);
    clipper.AddPath(lattice.path(area), ClipperLib::ptClip, true);
    ClipperLib::Paths paths;
    clipper.Execute(operation, paths, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    std::vector<Ring> rings;
    for (const ClipperLib::Path& path : paths) rings.push_back(lattice.ring(path));
    return withoutOpposites(rings);
}

}  // namespace

std::vector<Polygon> difference(const Polygon& polygon, std::span<const Ring> removed) {
    Lattice lattice(boundsOf(polygon.outer));
    ClipperLib::Clipper clipper;
    addSubject(polygon, lattice, clipper);
    for (const Ring& ring : removed) clipper.AddPath(lattice.path(ring), ClipperLib::ptClip, true);
    ClipperLib::PolyTree tree;
    clipper.Execute(ClipperLib::ctDifference, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);

    std::vector<Polygon> left;
    for (const ClipperLib::PolyNode* node = tree.GetFirst(); node; node = node->GetNext()) {
        if (node->IsHole()) continue;
        Polygon& part = left.emplace_back(Polygon{lattice.ring(node->Contour), {}});
        for (const ClipperLib::PolyNode* hole : node->Childs) part.holes.push_back(lattice.ring(hole->Contour));
    }
    std::ranges::stable_sort(left, std::ranges::greater{}, [](const Polygon& part) { return area(part); });
    return left;
}

std::vector<Ring> differenceBoundary(const Polygon& polygon, const Ring& removed) {
    return boundary(polygon, removed, ClipperLib::ctDifference);
}

std::vector<Ring> unionBoundary(const Polygon& polygon, const Ring& added) {
    return boundary(polygon, added, ClipperLib::ctUnion);
}

}  // namespace rubble
