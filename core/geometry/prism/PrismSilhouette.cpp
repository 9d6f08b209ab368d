#include "core/geometry/prism/PrismSilhouette.h"

#include <clipper.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

// The range of Clipper's integers, with the resolution of single precision: a finer one finds crossings caused by
// rounding.
constexpr double kSilhouetteRange = 1 << 24;

ClipperLib::Path projected(const AxisView& view, const std::array<std::uint32_t, 3>& triangle, Vec2 middle,
                           double scale) {
    ClipperLib::Path path;
    for (const std::uint32_t corner : triangle) {
        const Vec2 point = (Vec2(view.points[corner].x, view.points[corner].y) - middle) * scale;
        path.emplace_back(std::llround(point.x), std::llround(point.y));
    }
    if (!ClipperLib::Orientation(path)) std::ranges::reverse(path);
    return path;
}

/// The union by divide and conquer, which is much faster and more accurate than all at once.
ClipperLib::Paths unionOf(std::vector<ClipperLib::Paths> areas) {
    for (std::size_t step = 1; step < areas.size(); step *= 2) {
        for (std::size_t i = 0; i + step < areas.size(); i += 2 * step) {
            ClipperLib::Clipper clipper;
            clipper.AddPaths(areas[i], ClipperLib::ptSubject, true);
            clipper.AddPaths(areas[i + step], ClipperLib::ptSubject, true);
            clipper.Execute(ClipperLib::ctUnion, areas[i], ClipperLib::pftNonZero, ClipperLib::pftNonZero);
        }
    }
    return areas.empty() ? ClipperLib::Paths{} : areas[0];
}

}  // namespace

std::vector<Ring> silhouetteRings(const AxisView& view, const TriangleMesh& mesh) {
    Box2 box;
    for (const Vec3 point : view.points) box.include({point.x, point.y});
    const double size = std::max(box.size().x, box.size().y);
    if (!(size > 0.0)) return {};
    const Vec2 middle = box.min + box.size() / 2.0;
    const double scale = kSilhouetteRange / size;
    std::vector<ClipperLib::Paths> projections;
    for (const auto& triangle : mesh.triangles) {
        const ClipperLib::Path path = projected(view, triangle, middle, scale);
        if (ClipperLib::Area(path) != 0.0) projections.push_back({path});
    }
    std::vector<Ring> rings;
    for (const ClipperLib::Path& path : unionOf(std::move(projections))) {
        Ring& ring = rings.emplace_back();
        for (const ClipperLib::IntPoint point : path)
            ring.push_back(middle + Vec2(static_cast<double>(point.X), static_cast<double>(point.Y)) / scale);
    }
    return rings;
}

}  // namespace rubble
