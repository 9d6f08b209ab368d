#include "core/physics/queries/ShadowVolume.h"

#include <algorithm>
#include <cstdint>

namespace rubble {
namespace {

constexpr double kTolerance = 1e-5;  // m: single precision resolves 8 µm at 100 m

double heightOver(const Plane& plane, Vec3 point) { return glm::dot(plane.normal, point) - plane.offset; }

/// Whether a part of the polygon is behind the plane; one in the plane is not.
bool reachesBehind(const FacePolygon& polygon, const Plane& plane) {
    return std::ranges::any_of(polygon, [&](Vec3 corner) { return heightOver(plane, corner) < -kTolerance; });
}

/// The plane through the viewpoint and an edge; nothing in front of it is hidden. The edge runs counter-clockwise
/// around the face that is turned to the viewpoint.
void addSilhouette(ShadowVolume& volume, Vec3 from, Vec3 to) {
    constexpr double kMinArea = 1e-12;  // m²: the viewpoint is in line with the edge
    const Vec3 normal = glm::cross(from, to);
    const double size = glm::length(normal);
    if (size > kMinArea) volume.planes.push_back({normal / size, 0.0});
}

}  // namespace

SplitPolygon split(const FacePolygon& polygon, const Plane& plane) {
    SplitPolygon parts;
    bool isInFront = false, isBehind = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 from = polygon[k], to = polygon[k + 1 == polygon.size() ? 0 : k + 1];
        const double start = heightOver(plane, from), end = heightOver(plane, to);
        isInFront = isInFront || start > kTolerance;
        isBehind = isBehind || start < -kTolerance;
        if (start >= -kTolerance) parts.front.push_back(from);
        if (start <= kTolerance) parts.behind.push_back(from);
        const bool crosses = (start > kTolerance && end < -kTolerance) || (start < -kTolerance && end > kTolerance);
        if (!crosses) continue;
        const Vec3 crossing = from + (to - from) * (start / (start - end));
        parts.front.push_back(crossing);
        parts.behind.push_back(crossing);
    }
    if (!isInFront) parts.front.clear();
    if (isInFront && !isBehind) parts.behind.clear();
    return parts;
}

ShadowVolume shadowVolumeOf(const Hull& hull, const Mat3& rotation, Vec3 centre) {
    std::vector<Vec3> corners;
    corners.reserve(static_cast<std::size_t>(hull.cornerCount));
    for (int k = 0; k < hull.cornerCount; ++k) corners.push_back(rotation * toDouble(hull.corner(k)) + centre);
    ShadowVolume volume;
    std::vector<char> isTurned(hull.planes.size());
    for (std::size_t face = 0; face < hull.planes.size(); ++face) {
        const Vec3 normal = rotation * toDouble(hull.planes[face].normal);
        const double offset = static_cast<double>(hull.planes[face].offset) + glm::dot(normal, centre);
        if (!(offset < 0.0)) continue;
        isTurned[face] = 1;
        volume.planes.push_back({normal, offset});
        FacePolygon& polygon = volume.faces.emplace_back();
        for (const std::uint16_t corner : hull.face(static_cast<int>(face))) polygon.push_back(corners[corner]);
    }
    for (const HullEdge& edge : hull.edges) {
        if (isTurned[edge.firstFace] == isTurned[edge.secondFace]) continue;
        const bool isForward = isTurned[edge.firstFace] != 0;
        addSilhouette(volume, corners[isForward ? edge.from : edge.to], corners[isForward ? edge.to : edge.from]);
    }
    return volume;
}

bool isHidden(const ShadowVolume& volume, Vec3 point) {
    return !volume.planes.empty() &&
           std::ranges::all_of(volume.planes, [&](const Plane& plane) { return heightOver(plane, point) < 0.0; });
}

bool isHidden(const ShadowVolume& volume, const FacePolygon& polygon) {
    return !volume.planes.empty() && std::ranges::all_of(volume.planes, [&](const Plane& plane) {
        const auto isInFront = [&](Vec3 corner) { return heightOver(plane, corner) > kTolerance; };
        return std::ranges::none_of(polygon, isInFront) && reachesBehind(polygon, plane);
    });
}

bool subtractShadow(const FacePolygon& polygon, const ShadowVolume& volume, std::vector<FacePolygon>& visible) {
    if (volume.planes.empty()) return false;
    const auto isReached = [&](const Plane& plane) { return reachesBehind(polygon, plane); };
    if (!std::ranges::all_of(volume.planes, isReached)) return false;
    const std::size_t before = visible.size();
    FacePolygon rest = polygon;
    for (const Plane& plane : volume.planes) {
        if (!reachesBehind(rest, plane)) {  // the planes have only a part in common that the polygon misses
            visible.resize(before);
            return false;
        }
        SplitPolygon parts = split(rest, plane);
        if (parts.front.size() >= 3) visible.push_back(std::move(parts.front));
        rest = std::move(parts.behind);
    }
    return true;
}

}  // namespace rubble
