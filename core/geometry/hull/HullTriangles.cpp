#include "core/geometry/hull/HullTriangles.h"

#include "core/base/Index.h"

#include "core/geometry/predicates/Predicates.h"

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

using Simplex = std::array<std::uint32_t, 4>;

Error degenerate(std::size_t count, const char* where) {
    return {ErrorCode::Degenerate,
            "The " + std::to_string(count) + " points lie " + where + ", so they have no convex hull."};
}

/// Four points that are not coplanar, the last below the plane of the others.
Result<Simplex> firstSimplex(std::span<const Vec3> points) {
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
    if (orient3d(a, b, c, points[*fourth]) > 0) return Simplex{0, *second, *third, *fourth};
    return Simplex{0, *third, *second, *fourth};
}

/// A hull that is extended by one point at a time. Every point outside is in the outside set of one face that it sees.
class Quickhull {
public:
    Quickhull(std::span<const Vec3> points, const Simplex& simplex) : m_points(points), m_faceFrom(points.size()) {
        const auto [a, b, c, d] = simplex;
        m_faces = {{{{a, b, c}, {3, 2, 1}}, {}},
                   {{{a, c, d}, {0, 2, 3}}, {}},
                   {{{c, b, d}, {0, 3, 1}}, {}},
                   {{{b, a, d}, {0, 1, 2}}, {}}};
        for (std::uint32_t point = 0; point < points.size(); ++point) assign(point, 0);
    }

    void addAllPoints() {
        for (std::uint32_t face = 0; face < m_faces.size(); ++face) {
            if (m_faces[face].isAlive && !m_faces[face].outside.empty()) addPoint(farthestOutside(face), face);
        }
    }

    std::vector<HullTriangle> triangles() const {
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

private:
    struct Face {
        HullTriangle triangle;
        std::vector<std::uint32_t> outside;
        bool isAlive = true;
        std::uint32_t seenBy = kNone;  // the last point found to see it
    };
    struct HorizonEdge {
        std::uint32_t from;
        std::uint32_t to;
        std::uint32_t beyond;  // the face that remains
    };

    bool sees(std::uint32_t point, std::uint32_t face) const {
        const auto [a, b, c] = m_faces[face].triangle.corners;
        return orient3d(m_points[a], m_points[b], m_points[c], m_points[point]) < 0;
    }

    /// Adds the point to the outside set of the first face from `firstFace` on that it sees; a point that sees none is
    /// inside.
    void assign(std::uint32_t point, std::uint32_t firstFace) {
        for (std::uint32_t face = firstFace; face < m_faces.size(); ++face) {
            if (sees(point, face)) return m_faces[face].outside.push_back(point);
        }
    }

    std::uint32_t farthestOutside(std::uint32_t face) const {
        const auto [a, b, c] = m_faces[face].triangle.corners;
        const Vec3 origin = m_points[a];
        const Vec3 normal = glm::cross(m_points[b] - origin, m_points[c] - origin);
        std::uint32_t best = m_faces[face].outside[0];
        double most = glm::dot(normal, m_points[best] - origin);
        for (const std::uint32_t point : m_faces[face].outside) {
            const double height = glm::dot(normal, m_points[point] - origin);
            if (height < most || (height == most && point >= best)) continue;
            best = point;
            most = height;
        }
        return best;
    }

    /// Sets m_visible to all faces that the point sees, starting at one of them.
    void findVisible(std::uint32_t point, std::uint32_t start) {
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

    void findHorizon(std::uint32_t point) {
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

    /// Replaces the faces that the point sees by the cone from it over the horizon.
    void addPoint(std::uint32_t point, std::uint32_t start) {
        findVisible(point, start);
        findHorizon(point);
        const auto firstNew = static_cast<std::uint32_t>(m_faces.size());
        for (const HorizonEdge& edge : m_horizon) {
            m_faceFrom[edge.from] = static_cast<std::uint32_t>(m_faces.size());
            linkBeyond(edge, m_faceFrom[edge.from]);
            m_faces.push_back({{{edge.from, edge.to, point}, {edge.beyond, kNone, kNone}}, {}});
        }
        for (std::uint32_t face = firstNew; face < m_faces.size(); ++face) {
            const std::uint32_t after = m_faceFrom[m_faces[face].triangle.corners[1]];
            m_faces[face].triangle.neighbours[1] = after;
            m_faces[after].triangle.neighbours[2] = face;
        }
        for (const std::uint32_t face : m_visible) {
            m_faces[face].isAlive = false;
            const std::vector<std::uint32_t> unassigned = std::move(m_faces[face].outside);
            for (const std::uint32_t other : unassigned) {
                if (other != point) assign(other, firstNew);
            }
        }
    }

    void linkBeyond(const HorizonEdge& edge, std::uint32_t face) {
        HullTriangle& beyond = m_faces[edge.beyond].triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            if (beyond.corners[i] == edge.to && beyond.corners[(i + 1) % 3] == edge.from) beyond.neighbours[i] = face;
        }
    }

    std::span<const Vec3> m_points;
    std::vector<Face> m_faces;
    std::vector<std::uint32_t> m_visible;
    std::vector<HorizonEdge> m_horizon;
    std::vector<std::uint32_t> m_faceFrom;  // per point: the new face whose horizon edge starts there
};

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

Result<std::vector<HullTriangle>> hullTriangles(std::span<const Vec3> points) {
    if (std::optional<Error> fault = inputFault(points)) return *fault;
    const Result<Simplex> simplex = firstSimplex(points);
    if (!simplex) return simplex.error();
    Quickhull hull(points, *simplex);
    hull.addAllPoints();
    return hull.triangles();
}

}  // namespace rubble
