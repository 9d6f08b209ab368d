#include "core/geometry/hull/GrowingHull.h"

#include "core/geometry/predicates/Predicates.h"

#include <cmath>
#include <optional>
#include <string>

namespace rubble {

namespace {

bool areCollinear(Vec3 a, Vec3 b, Vec3 c) {
    return orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) == 0 && orient2d({a.y, a.z}, {b.y, b.z}, {c.y, c.z}) == 0 &&
           orient2d({a.z, a.x}, {b.z, b.x}, {c.z, c.x}) == 0;
}

/// The index of the point with the largest measure of those accepted by `isUsable`, an exact predicate that is called
/// for maxima only; nothing if none is.
template <class Measure, class IsUsable>
std::optional<std::uint32_t> farthest(std::span<const Vec3> points, Measure measure, IsUsable isUsable) {
    std::optional<std::uint32_t> best;
    double most = 0.0;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const double value = measure(points[i]);
        if (best && !(value > most)) continue;
        if (!isUsable(points[i])) continue;
        best = i;
        most = value;
    }
    return best;
}

Error degenerate(std::size_t count, const char* where) {
    return {ErrorCode::Degenerate,
            "The " + std::to_string(count) + " points lie " + where + ", so they have no convex hull."};
}

std::optional<Error> inputFault(std::span<const Vec3> points) {
    if (points.size() < 4) {
        std::string message = "A hull needs at least four points; there are ";
        message += std::to_string(points.size()) + ".";
        return Error{ErrorCode::BadInput, message};
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const double value = points[i][axis];
            if (isExactlyUsable(value)) continue;
            std::string message = "Coordinate ";
            message += "xyz"[axis];
            message += " of point " + std::to_string(i);
            message += std::isfinite(value) ? " is too large or too small to be exact." : " is not finite.";
            return Error{ErrorCode::BadInput, message};
        }
    }
    return std::nullopt;
}

}  // namespace

Result<HullSimplex> firstSimplex(std::span<const Vec3> points) {
    if (std::optional<Error> fault = inputFault(points)) return *fault;
    const Vec3 a = points[0];
    const auto second = farthest(
        points, [&](Vec3 p) { return glm::dot(p - a, p - a); }, [&](Vec3 p) { return p != a; });
    if (!second) return degenerate(points.size(), "at one point");
    const Vec3 b = points[*second];
    const auto offLine = [&](Vec3 p) {
        const Vec3 normal = glm::cross(b - a, p - a);
        return glm::dot(normal, normal);
    };
    const auto third = farthest(points, offLine, [&](Vec3 p) { return !areCollinear(a, b, p); });
    if (!third) return degenerate(points.size(), "on one line");
    const Vec3 c = points[*third];
    const Vec3 normal = glm::cross(b - a, c - a);
    const auto fourth = farthest(
        points, [&](Vec3 p) { return std::abs(glm::dot(normal, p - a)); },
        [&](Vec3 p) { return orient3d(a, b, c, p) != 0; });
    if (!fourth) return degenerate(points.size(), "in one plane");
    if (orient3d(a, b, c, points[*fourth]) > 0) return HullSimplex{0, *second, *third, *fourth};
    return HullSimplex{0, *third, *second, *fourth};
}

GrowingHull::GrowingHull(std::span<const Vec3> points, const HullSimplex& simplex)
    : m_points(points), m_faceFrom(points.size()) {
    const auto [a, b, c, d] = simplex;
    m_faces = {{.triangle = {{a, b, c}, {3, 2, 1}}},
               {.triangle = {{a, c, d}, {0, 2, 3}}},
               {.triangle = {{c, b, d}, {0, 3, 1}}},
               {.triangle = {{b, a, d}, {0, 1, 2}}}};
}

bool GrowingHull::sees(std::uint32_t point, std::uint32_t face) const {
    const auto [a, b, c] = m_faces[face].triangle.corners;
    return orient3d(m_points[a], m_points[b], m_points[c], m_points[point]) < 0;
}

std::vector<HullTriangle> GrowingHull::triangles() const {
    std::vector<std::uint32_t> newIndex(m_faces.size(), kNone);
    std::uint32_t count = 0;
    for (std::uint32_t face = 0; face < m_faces.size(); ++face) {
        if (m_faces[face].isAlive) newIndex[face] = count++;
    }
    std::vector<HullTriangle> result;
    result.reserve(count);
    for (const Face& face : m_faces) {
        if (!face.isAlive) continue;
        HullTriangle& triangle = result.emplace_back(face.triangle);
        for (std::uint32_t& neighbour : triangle.neighbours) neighbour = newIndex[neighbour];
    }
    return result;
}

/// Sets m_visible to all faces that the point sees, starting at one of them.
void GrowingHull::findVisible(std::uint32_t point, std::uint32_t start) {
    m_visible.assign(1, start);
    m_faces[start].seenBy = point;
    for (std::size_t next = 0; next < m_visible.size(); ++next) {
        const std::array<std::uint32_t, 3> neighbours = m_faces[m_visible[next]].triangle.neighbours;
        for (const std::uint32_t neighbour : neighbours) {
            if (m_faces[neighbour].seenBy == point || !sees(point, neighbour)) continue;
            m_faces[neighbour].seenBy = point;
            m_visible.push_back(neighbour);
        }
    }
}

void GrowingHull::findHorizon(std::uint32_t point) {
    m_horizon.clear();
    for (const std::uint32_t face : m_visible) {
        const HullTriangle& triangle = m_faces[face].triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t beyond = triangle.neighbours[i];
            if (m_faces[beyond].seenBy == point) continue;
            m_horizon.push_back({triangle.corners[i], triangle.corners[(i + 1) % 3], beyond});
        }
    }
}

std::uint32_t GrowingHull::add(std::uint32_t point, std::uint32_t start) {
    findVisible(point, start);
    findHorizon(point);
    const std::uint32_t firstNew = faceCount();
    for (const HorizonEdge& edge : m_horizon) {
        m_faceFrom[edge.from] = faceCount();
        linkBeyond(edge, m_faceFrom[edge.from]);
        m_faces.push_back({.triangle = {{edge.from, edge.to, point}, {edge.beyond, kNone, kNone}}});
    }
    for (std::uint32_t face = firstNew; face < m_faces.size(); ++face) {
        const std::uint32_t after = m_faceFrom[m_faces[face].triangle.corners[1]];
        m_faces[face].triangle.neighbours[1] = after;
        m_faces[after].triangle.neighbours[2] = face;
    }
    for (const std::uint32_t face : m_visible) m_faces[face].isAlive = false;
    return firstNew;
}

void GrowingHull::linkBeyond(const HorizonEdge& edge, std::uint32_t face) {
    HullTriangle& beyond = m_faces[edge.beyond].triangle;
    for (std::size_t i = 0; i < 3; ++i) {
        if (beyond.corners[i] == edge.to && beyond.corners[(i + 1) % 3] == edge.from) beyond.neighbours[i] = face;
    }
}

}  // namespace rubble
