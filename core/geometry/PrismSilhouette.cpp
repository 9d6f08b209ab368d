#include "core/geometry/PrismSilhouette.h"

#include <clipper.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

// Clipper works on integers; up to this magnitude it needs no wide ones.
constexpr double kClipperRange = 1 << 29;

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

}  // namespace

std::vector<Ring> silhouetteRings(const AxisView& view, const TriangleMesh& mesh) {
    Box2 box;
    for (const Vec3 point : view.points) box.include({point.x, point.y});
    const double size = std::max(box.size().x, box.size().y);
    if (!(size > 0.0)) return {};
    const Vec2 middle = box.min + box.size() / 2.0;
    const double scale = kClipperRange / size;
    ClipperLib::Clipper clipper;
    clipper.StrictlySimple(true);
    for (const auto& triangle : mesh.triangles) {
        const ClipperLib::Path path = projected(view, triangle, middle, scale);
        if (ClipperLib::Area(path) != 0.0) clipper.AddPath(path, ClipperLib::ptSubject, true);
    }
    ClipperLib::Paths paths;
    clipper.Execute(ClipperLib::ctUnion, paths, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    std::vector<Ring> rings;
    for (const ClipperLib::Path& path : paths) {
        Ring& ring = rings.emplace_back();
        for (const ClipperLib::IntPoint point : path)
            ring.push_back(middle + Vec2(static_cast<double>(point.X), static_cast<double>(point.Y)) / scale);
    }
    return rings;
}

}  // namespace rubble
