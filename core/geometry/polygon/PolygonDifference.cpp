#include "core/geometry/polygon/PolygonDifference.h"

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
    Ring ring(const ClipperLib::Path& path) const {
        Ring ring;
        for (const ClipperLib::IntPoint point : path) {
            const auto kept = m_kept.find({point.X, point.Y});
            const Vec2 numbers(static_cast<double>(point.X), static_cast<double>(point.Y));
            ring.push_back(kept != m_kept.end() ? kept->second : m_middle + numbers / m_scale);
        }
        return ring;
    }

private:
    ClipperLib::IntPoint at(Vec2 point) const {
        const Vec2 numbers = glm::clamp((point - m_middle) * m_scale, -kMaxClipperCoordinate * kClipperRange,
                                        kMaxClipperCoordinate * kClipperRange);
        return {std::llround(numbers.x), std::llround(numbers.y)};
    }

    Vec2 m_middle;
    double m_scale;
    std::map<std::array<ClipperLib::cInt, 2>, Vec2> m_kept;
};

}  // namespace

std::vector<Polygon> difference(const Polygon& polygon, std::span<const Ring> removed) {
    Lattice lattice(boundsOf(polygon.outer));
    ClipperLib::Clipper clipper;
    clipper.StrictlySimple(true);
    lattice.keep(polygon.outer);
    clipper.AddPath(lattice.path(polygon.outer), ClipperLib::ptSubject, true);
    for (const Ring& hole : polygon.holes) {
        lattice.keep(hole);
        clipper.AddPath(lattice.path(hole), ClipperLib::ptSubject, true);
    }
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

}  // namespace rubble
