#include "core/geometry/hull/InsetHull.h"

#include "core/base/Assert.h"
#include "core/geometry/hull/ConvexHull.h"
#include "core/geometry/hull/HalfSpaceIntersection.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/hull/SimplifiedHull.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble {
namespace {

constexpr double kMinSine = 1e-12;  // of the angle between two sides whose lines are intersected

std::span<const Plane> sidesOf(const Polytope& prism) { return std::span(prism.planes).subspan(2); }

Vec2 cornerOf(const Polytope& prism, std::size_t corner) { return Vec2(prism.vertices[corner]); }

/// The displacement of the corner between two sides that move outwards by `distance`.
Vec2 displacement(Vec2 before, Vec2 after, double distance) {
    return (before + after) * (distance / (1.0 + glm::dot(before, after)));
}

/// A ring whose sides move inwards until no side runs backwards.
class ShrinkingRing {
public:
    ShrinkingRing(const Polytope& prism, double distance) {
        const std::span<const Plane> sides = sidesOf(prism);
        for (std::size_t k = 0; k < sides.size(); ++k) {
            const Vec2 normal(sides[k].normal), before(sides[(k + sides.size() - 1) % sides.size()].normal);
            m_sides.push_back({normal, sides[k].offset - distance});
            m_corners.push_back(cornerOf(prism, k) + displacement(before, normal, -distance));
        }
    }

    /// The ring; fewer than three corners: nothing is left.
    Ring ring() && {
        while (m_sides.size() >= 3 && removeShortest()) {
        }
        return m_sides.size() < 3 ? Ring() : std::move(m_corners);
    }

private:
    struct Side {
        Vec2 normal;
        double offset = 0.0;
    };
    std::size_t after(std::size_t side) const { return side + 1 < m_sides.size() ? side + 1 : 0; }

    /// Removes the side that runs backwards the most; returns whether there is one.
    bool removeShortest() {
        std::size_t shortest = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < m_sides.size(); ++k) {
            const double length = cross(m_sides[k].normal, m_corners[after(k)] - m_corners[k]);
            if (length < least) {
                least = length;
                shortest = k;
            }
        }
        if (least > 0.0) return false;
        const std::size_t next = after(shortest);
        const Vec2 middle = (m_corners[shortest] + m_corners[next]) * 0.5;
        const Side& before = m_sides[shortest > 0 ? shortest - 1 : m_sides.size() - 1];
        m_corners[next] = intersection(before, m_sides[next]).value_or(middle);
        m_sides.erase(m_sides.begin() + static_cast<std::ptrdiff_t>(shortest));
        m_corners.erase(m_corners.begin() + static_cast<std::ptrdiff_t>(shortest));
        return true;
    }
    static std::optional<Vec2> intersection(const Side& a, const Side& b) {
        const double sine = cross(a.normal, b.normal);
        if (std::abs(sine) < kMinSine) return std::nullopt;
        return Vec2(a.offset * b.normal.y - b.offset * a.normal.y, b.offset * a.normal.x - a.offset * b.normal.x) /
               sine;
    }

    std::vector<Side> m_sides;    // counter-clockwise
    std::vector<Vec2> m_corners;  // where each side starts
};

InsetHull insetPrism(const Polytope& prism, double inset) {
    const Ring ring = ShrinkingRing(prism, inset).ring();
    if (ring.size() < 3) return {prism, 0.0};
    const double front = prism.planes[0].offset - inset, back = inset - prism.planes[1].offset;
    InsetHull hull{extruded(ring, back, front), inset};
    return hull.polytope.vertices.empty() ? InsetHull{prism, 0.0} : hull;
}

/// The least extent of a polytope across one of its faces, m.
double thinnestAcrossFaces(const Polytope& polytope) {
    double thinnest = std::numeric_limits<double>::infinity();
    for (const Plane& plane : polytope.planes) {
        double lowest = plane.offset;
        for (const Vec3& vertex : polytope.vertices) lowest = std::min(lowest, glm::dot(plane.normal, vertex));
        thinnest = std::min(thinnest, plane.offset - lowest);
    }
    return thinnest;
}

/// The hull of the vertices of a polytope as single-precision numbers, as files and engines have them, without those
/// that are nearer than `least` m to another: in fewer digits no face of it vanishes or turns over.
std::optional<Polytope> inSinglePrecision(const Polytope& polytope, double least) {
    std::vector<Vec3> kept;
    for (const Vec3& vertex : polytope.vertices) {
        const auto isNear = [&](const Vec3& other) { return glm::distance(vertex, other) < least; };
        if (std::ranges::none_of(kept, isNear)) kept.emplace_back(glm::vec3(vertex));
    }
    Result<Polytope> hull = convexHull(kept);
    return hull ? std::optional(std::move(*hull)) : std::nullopt;
}

InsetHull insetPolytope(const Polytope& polytope, double inset) {
    constexpr double kMinEdge = 0.125;     // of the inset
    constexpr double kHalfUnit = 0x1p-24;  // of a number: the rounding error of single precision
    double farthest = 0.0;
    for (const Vec3& vertex : polytope.vertices) farthest = std::max(farthest, glm::length(vertex));
    if (kHalfUnit * farthest > inset) return {polytope, 0.0};  // rounding may move a corner farther than its faces
    std::vector<Plane> planes = polytope.planes;
    for (Plane& plane : planes) plane.offset -= inset;
    std::optional<Polytope> shrunk = halfSpaceIntersection(planes, massOf(polytope).centre);
    if (shrunk) shrunk = inSinglePrecision(*shrunk, kMinEdge * inset);
    // Faces that move split corners at which more than three meet.
    const std::size_t maxCorners = std::max(kMaxCollisionCorners, polytope.vertices.size());
    if (shrunk && shrunk->vertices.size() > maxCorners)
        shrunk = simplifiedHull(*shrunk, {.tolerance = kMinEdge * inset, .maxCorners = maxCorners});
    return shrunk ? InsetHull{std::move(*shrunk), inset} : InsetHull{polytope, 0.0};
}

}  // namespace

bool isPrism(const Polytope& polytope) {
    const std::size_t count = polytope.vertices.size() / 2;
    if (count < 3 || polytope.vertices.size() % 2 != 0 || polytope.faces.size() != count + 2) return false;
    if (polytope.planes.size() != polytope.faces.size()) return false;
    const auto hasFace = [&](std::size_t face, std::span<const std::size_t> loop) {
        const std::vector<std::uint32_t>& own = polytope.faces[face];
        const auto start = static_cast<std::size_t>(std::ranges::find(own, loop[0]) - own.begin());
        if (own.size() != loop.size() || start == own.size()) return false;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            if (own[(start + k) % own.size()] != loop[k]) return false;
        }
        return true;
    };
    std::vector<std::size_t> front(count), back(count);
    for (std::size_t k = 0; k < count; ++k) {
        front[k] = k;
        back[k] = 2 * count - 1 - k;
        const std::size_t next = k + 1 < count ? k + 1 : 0;
        if (!hasFace(k + 2, std::array{k, count + k, count + next, next})) return false;
        if (Vec2(polytope.vertices[k]) != Vec2(polytope.vertices[count + k])) return false;
        if (polytope.planes[k + 2].normal.z != 0.0) return false;
    }
    return hasFace(0, front) && hasFace(1, back) && polytope.planes[0].normal == Vec3(0.0, 0.0, 1.0) &&
           polytope.planes[1].normal == Vec3(0.0, 0.0, -1.0);
}

double thinnestWidth(const Polytope& hull) {
    if (!isPrism(hull)) return thinnestAcrossFaces(hull);
    const Polytope& prism = hull;
    RUBBLE_ASSERT(prism.planes.size() >= 5);
    // The width of a product of a convex ring and an interval is the smaller of theirs, and that of a ring is across
    // one of its sides.
    const std::span<const Plane> sides = sidesOf(prism);
    double thinnest = prism.planes[0].offset + prism.planes[1].offset;
    std::size_t opposite = 1;  // the first side that does not lead away: the farthest corner is where it starts
    for (std::size_t side = 0; side < sides.size(); ++side) {
        const auto leadsAway = [&](std::size_t other) {
            return other != side && cross(Vec2(sides[side].normal), Vec2(sides[other].normal)) > 0.0;
        };
        if (opposite == side) opposite = (side + 1) % sides.size();
        for (std::size_t k = 0; k < sides.size() && leadsAway(opposite); ++k) opposite = (opposite + 1) % sides.size();
        const double width = sides[side].offset - glm::dot(Vec2(sides[side].normal), cornerOf(prism, opposite));
        thinnest = std::min(thinnest, std::max(width, 0.0));
    }
    return thinnest;
}

InsetHull insetHull(const Polytope& hull, double distance) {
    const double inset = std::min(distance, kMaxInset * thinnestWidth(hull));
    if (!(inset > 0.0)) return {hull, 0.0};
    return isPrism(hull) ? insetPrism(hull, inset) : insetPolytope(hull, inset);
}

std::optional<Polytope> solidOf(const InsetHull& hull) {
    if (hull.inset == 0.0) return hull.polytope;
    if (!isPrism(hull.polytope)) {
        std::vector<Plane> planes = hull.polytope.planes;
        for (Plane& plane : planes) plane.offset += hull.inset;
        return halfSpaceIntersection(planes, massOf(hull.polytope).centre);
    }
    Polytope solid = hull.polytope;
    const std::size_t count = solid.vertices.size() / 2;
    for (Plane& plane : solid.planes) plane.offset += hull.inset;
    for (std::size_t k = 0; k < count; ++k) {
        const Vec2 before(solid.planes[k > 0 ? k + 1 : count + 1].normal), after(solid.planes[k + 2].normal);
        const Vec2 moved = cornerOf(solid, k) + displacement(before, after, hull.inset);
        solid.vertices[k] = Vec3(moved, solid.planes[0].offset);
        solid.vertices[count + k] = Vec3(moved, -solid.planes[1].offset);
    }
    return solid;
}

}  // namespace rubble
