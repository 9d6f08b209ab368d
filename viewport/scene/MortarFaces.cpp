#include "viewport/scene/MortarFaces.h"

#include "core/asset/project/AssetShape.h"
#include "core/fracture/pattern/PatternCuts.h"
#include "core/geometry/polygon/ConvexParts.h"
#include "core/geometry/polygon/IndexedCorners.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr double kRecessOfJoint = 0.3;
constexpr double kMaxRecessOfDepth = 0.1;

Vec2 outwardNormal(Vec2 from, Vec2 to) {
    const Vec2 along = glm::normalize(to - from);
    return {along.y, -along.x};
}

/// The part of a convex ring that lies at least `distance` behind the line through two points.
Ring clipped(const Ring& ring, Vec2 from, Vec2 to, double distance) {
    const Vec2 normal = outwardNormal(from, to);
    const auto height = [&](Vec2 point) { return glm::dot(point - from, normal) + distance; };
    Ring kept;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 here = ring[k], next = ring[(k + 1) % ring.size()];
        const double now = height(here), then = height(next);
        if (now <= 0.0) kept.push_back(here);
        if ((now < 0.0 && then > 0.0) || (now > 0.0 && then < 0.0))
            kept.push_back(here + (next - here) * (now / (now - then)));
    }
    return kept;
}

void addSide(std::vector<PlainFace>& faces, Vec2 from, Vec2 to, double z) {
    if (from == to) return;
    faces.push_back({Vec3(outwardNormal(from, to), 0.0), {Vec3(from, -z), Vec3(to, -z), Vec3(to, z), Vec3(from, z)}});
}

void addCaps(std::vector<PlainFace>& faces, const Ring& ring, double z) {
    PlainFace front{{0.0, 0.0, 1.0}, {}}, back{{0.0, 0.0, -1.0}, {}};
    for (const Vec2 point : ring) front.corners.emplace_back(point, z);
    for (const Vec2 point : ring) back.corners.emplace_back(point, -z);
    std::ranges::reverse(back.corners);
    faces.push_back(std::move(front));
    faces.push_back(std::move(back));
}

}  // namespace

MortarFaces::MortarFaces(const Asset& asset)
    : m_joint(jointWidthOf(asset.pattern)),
      m_recess(std::min(kRecessOfJoint * m_joint, kMaxRecessOfDepth * sizeOf(asset).z)) {}

std::vector<PlainFace> MortarFaces::around(const BakedFragment& fragment) const {
    std::vector<PlainFace> faces;
    const std::optional<ExtrudedFragment> extruded = fragment.solid.extruded();
    if (!isThere() || fragment.level > 0 || !extruded) return faces;
    const Polygon cell = extruded->cell();
    const std::vector<std::uint32_t> neighbours = extruded->cellNeighbours();
    const double z = extruded->depth() / 2.0 - m_recess;
    if (cell.holes.empty() && isConvex(cell.outer)) {
        Ring ring = cell.outer;
        for (std::size_t k = 0; k < cell.outer.size() && !ring.empty(); ++k) {
            if (neighbours[k] == kNone)
                ring = clipped(ring, cell.outer[k], cell.outer[(k + 1) % cell.outer.size()], m_recess);
        }
        if (ring.size() < 3) return faces;
        addCaps(faces, ring, z);
        for (std::size_t k = 0; k < ring.size(); ++k) addSide(faces, ring[k], ring[(k + 1) % ring.size()], z);
        return faces;
    }
    const std::vector<Vec2> points = indexedCorners(cell).points;
    const Result<IndexLoops> parts = convexParts(cell);
    for (const std::vector<std::uint32_t>& part : parts ? *parts : IndexLoops()) {
        Ring ring;
        for (const std::uint32_t corner : part) ring.push_back(points[corner]);
        addCaps(faces, ring, z);
    }
    std::size_t edge = 0;
    const auto addSides = [&](const Ring& ring) {
        for (std::size_t k = 0; k < ring.size(); ++k, ++edge) {
            if (neighbours[edge] != kNone) addSide(faces, ring[k], ring[(k + 1) % ring.size()], z);
        }
    };
    addSides(cell.outer);
    for (const Ring& hole : cell.holes) addSides(hole);
    return faces;
}

}  // namespace rubble
