#include "core/structure/capacity/BondPainting.h"

#include "core/geometry/predicates/Predicates.h"
#include "core/geometry/predicates/SegmentDistance.h"
#include "core/geometry/search/BoxTree.h"
#include "core/structure/bonds/FragmentSilhouette.h"

#include <algorithm>

namespace rubble {
namespace {

using Segment = std::array<Vec2, 2>;

/// Whether two segments cross at a point inside both; where they only touch, an end is at distance 0.
bool crossInside(const Segment& a, const Segment& b) {
    return orient2d(a[0], a[1], b[0]) * orient2d(a[0], a[1], b[1]) < 0 &&
           orient2d(b[0], b[1], a[0]) * orient2d(b[0], b[1], a[1]) < 0;
}

double distanceOf(const Segment& a, const Segment& b) {
    if (crossInside(a, b)) return 0.0;
    return std::min({distanceToSegment(a[0], b[0], b[1]), distanceToSegment(a[1], b[0], b[1]),
                     distanceToSegment(b[0], a[0], a[1]), distanceToSegment(b[1], a[0], a[1])});
}

bool isWithinOf(const Segment& segment, double radius, const Polygon& polygon) {
    if (containment(polygon, segment[0]) != Containment::Outside) return true;
    return std::ranges::any_of(edgesOf(polygon),
                               [&](const Segment& edge) { return distanceOf(segment, edge) <= radius; });
}

/// The lines of a stroke; a single point is a line of length zero.
std::vector<Segment> linesOf(const BondStroke& stroke) {
    std::vector<Segment> lines;
    for (std::size_t k = 0; k + 1 < stroke.points.size(); ++k)
        lines.push_back({stroke.points[k], stroke.points[k + 1]});
    if (lines.empty() && !stroke.points.empty()) lines.push_back({stroke.points[0], stroke.points[0]});
    return lines;
}

/// The outline of a fragment in the frame of its offset.
Polygon placedOutline(const Fragment& fragment) {
    const Vec2 offset{fragment.offset()};
    Polygon outline = silhouetteOf(fragment);
    for (Vec2& corner : outline.outer) corner += offset;
    for (Ring& hole : outline.holes) {
        for (Vec2& corner : hole) corner += offset;
    }
    return outline;
}

Box3 grownBox(const Segment& segment, double radius) {
    Box3 box = boxOf(segment[0], segment[1]);
    box.min -= Vec3(radius);
    box.max += Vec3(radius);
    return box;
}

}  // namespace

bool touches(const BondStroke& stroke, const Polygon& polygon) {
    return std::ranges::any_of(linesOf(stroke),
                               [&](const Segment& line) { return isWithinOf(line, stroke.radius, polygon); });
}

std::vector<bool> paintedFragments(const Fragments& fragments, std::span<const BondStroke> strokes, BondBrush brush) {
    std::vector<bool> isPainted(fragments.count(), false);
    if (std::ranges::find(strokes, brush, &BondStroke::brush) == strokes.end()) return isPainted;
    std::vector<Polygon> outlines;
    std::vector<Box3> boxes;
    for (std::uint32_t k = 0; k < fragments.count(); ++k) {
        outlines.push_back(placedOutline(fragments[k]));
        const Box2 bounds = boundsOf(outlines.back().outer);
        boxes.push_back(boxOf(bounds.min, bounds.max));
    }
    const BoxTree tree(boxes);
    for (const BondStroke& stroke : strokes) {
        if (stroke.brush != brush) continue;
        for (const Segment& line : linesOf(stroke)) {
            tree.visitOverlapping(grownBox(line, stroke.radius), [&](std::uint32_t k) {
                if (isPainted[k] != stroke.isErasing) return;  // as it is already
                if (isWithinOf(line, stroke.radius, outlines[k])) isPainted[k] = !stroke.isErasing;
            });
        }
    }
    return isPainted;
}

}  // namespace rubble
