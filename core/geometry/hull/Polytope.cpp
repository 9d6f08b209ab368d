#include "core/geometry/hull/Polytope.h"

#include "core/base/Assert.h"
#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

// Consecutive edges with a smaller angle count as collinear, if a loop can start elsewhere.
constexpr double kMinSine = 1e-6;  // sine of the angle

bool isStrictlyConvex(std::span<const Vec2> ring) {
    Vec2 before = ring[ring.size() - 2];
    Vec2 corner = ring[ring.size() - 1];
    for (const Vec2 after : ring) {
        if (orient2d(before, corner, after) <= 0) return false;
        before = corner;
        corner = after;
    }
    return true;
}

/// The strictly convex corners, in the ring's order, by a Graham scan from the smallest corner, which is on the hull.
Ring strictlyConvexCorners(std::span<const Vec2> ring) {
    const std::size_t count = ring.size();
    const auto smallest =
        static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), lexicographicLess) - ring.begin());
    std::vector<std::size_t> kept{smallest};
    for (std::size_t step = 1; step <= count; ++step) {
        const std::size_t next = (smallest + step) % count;
        while (kept.size() > 1 && orient2d(ring[kept[kept.size() - 2]], ring[kept.back()], ring[next]) <= 0) {
            kept.pop_back();
        }
        if (step < count && ring[next] != ring[kept.back()]) kept.push_back(next);
    }
    std::sort(kept.begin(), kept.end());
    Ring corners;
    for (const std::size_t index : kept) corners.push_back(ring[index]);
    return corners;
}

void addPrismEdges(std::uint32_t count, Polytope& prism) {
    prism.edges.resize(std::size_t{3} * count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t next = i + 1 < count ? i + 1 : 0;
        prism.edges[i] = {i, next};
        prism.edges[count + i] = {count + i, count + next};
        prism.edges[2 * count + i] = {i, count + i};
    }
}

void addPrismFaces(std::uint32_t count, Polytope& prism) {
    prism.faces.resize(std::size_t{count} + 2);
    prism.faces[0].resize(count);
    prism.faces[1].resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t next = i + 1 < count ? i + 1 : 0;
        prism.faces[0][i] = i;
        prism.faces[1][i] = 2 * count - 1 - i;
        prism.faces[i + 2] = {i, count + i, count + next, next};
    }
}

/// The plane along z through the ring's edge from a to b, with the outside on the right.
Plane sidePlane(Vec2 a, Vec2 b) {
    const Vec2 along = b - a;
    const double length = std::sqrt(along.x * along.x + along.y * along.y);
    const Vec3 normal{along.y / length, -along.x / length, 0.0};
    return {normal, normal.x * a.x + normal.y * a.y};
}

Polytope extrude(std::span<const Vec2> ring, double zMin, double zMax) {
    const auto count = static_cast<std::uint32_t>(ring.size());
    Polytope prism;
    if (count < 3) return prism;
    prism.vertices.resize(2 * ring.size());
    prism.planes.reserve(ring.size() + 2);
    prism.planes.push_back({{0.0, 0.0, 1.0}, zMax});
    prism.planes.push_back({{0.0, 0.0, -1.0}, -zMin});
    for (std::uint32_t i = 0; i < count; ++i) {
        prism.vertices[i] = {ring[i].x, ring[i].y, zMax};
        prism.vertices[count + i] = {ring[i].x, ring[i].y, zMin};
        prism.planes.push_back(sidePlane(ring[i], ring[i + 1 < count ? i + 1 : 0]));
    }
    addPrismEdges(count, prism);
    addPrismFaces(count, prism);
    return prism;
}

/// Finds the edges of a polytope by their ends.
class EdgeLookup {
public:
    explicit EdgeLookup(const Polytope& polytope) : m_polytope(polytope) {}

    std::uint32_t edgeBetween(std::uint32_t a, std::uint32_t b) {
        // Guesses for prisms: an edge of a cap has the index of its first vertex, side edges follow.
        const auto sideEdge = static_cast<std::uint32_t>(m_polytope.vertices.size()) + std::min(a, b);
        for (const std::uint32_t guess : {a, b, sideEdge}) {
            if (guess < m_polytope.edges.size() && endsOf(guess) == Ends(std::minmax(a, b))) return guess;
        }
        return sortedEdgeBetween(std::minmax(a, b));
    }

private:
    using Ends = std::pair<std::uint32_t, std::uint32_t>;

    Ends endsOf(std::uint32_t edge) const { return std::minmax(m_polytope.edges[edge][0], m_polytope.edges[edge][1]); }
    std::uint32_t sortedEdgeBetween(Ends ends) {
        for (auto edge = static_cast<std::uint32_t>(m_sorted.size()); edge < m_polytope.edges.size(); ++edge) {
            m_sorted.push_back({endsOf(edge), edge});
            if (edge + 1 == m_polytope.edges.size()) std::sort(m_sorted.begin(), m_sorted.end());
        }
        const auto found = std::lower_bound(m_sorted.begin(), m_sorted.end(), std::pair(ends, 0u));
        RUBBLE_ASSERT(found != m_sorted.end() && found->first == ends);
        return found->second;
    }

    const Polytope& m_polytope;
    std::vector<std::pair<Ends, std::uint32_t>> m_sorted;  // built on first use
};

/// The squared sine of the angle between the loop's edge at `index` and the next one.
double squaredSine(const Polytope& polytope, const std::vector<std::uint32_t>& loop, std::size_t index) {
    const Vec3 a = polytope.vertices[loop[index]];
    const Vec3 b = polytope.vertices[loop[(index + 1) % loop.size()]];
    const Vec3 c = polytope.vertices[loop[(index + 2) % loop.size()]];
    const Vec3 normal = glm::cross(b - a, c - b);
    return glm::dot(normal, normal) / (glm::dot(b - a, b - a) * glm::dot(c - b, c - b));
}

std::size_t firstNonCollinear(const Polytope& polytope, const std::vector<std::uint32_t>& loop) {
    std::size_t best = 0;
    double most = 0.0;
    for (std::size_t index = 0; index < loop.size(); ++index) {
        const double sine = squaredSine(polytope, loop, index);
        if (sine > kMinSine * kMinSine) return index;
        if (sine > most) {
            most = sine;
            best = index;
        }
    }
    return best;
}

}  // namespace

Polytope extruded(std::span<const Vec2> convexRing, double zMin, double zMax) {
    RUBBLE_ASSERT(convexRing.size() >= 3 && zMin < zMax);
    if (isStrictlyConvex(convexRing)) return extrude(convexRing, zMin, zMax);
    return extrude(strictlyConvexCorners(convexRing), zMin, zMax);
}

std::vector<std::vector<SignedEdge>> signedEdgeLoops(const Polytope& polytope) {
    EdgeLookup lookup(polytope);
    std::vector<std::vector<SignedEdge>> loops;
    loops.reserve(polytope.faces.size());
    for (const std::vector<std::uint32_t>& face : polytope.faces) {
        const std::size_t start = firstNonCollinear(polytope, face);
        std::vector<SignedEdge>& loop = loops.emplace_back();
        loop.reserve(face.size());
        std::uint32_t from = face[start];
        for (std::size_t step = 1; step <= face.size(); ++step) {
            const std::size_t next = start + step;
            const std::uint32_t to = face[next < face.size() ? next : next - face.size()];
            const std::uint32_t edge = lookup.edgeBetween(from, to);
            loop.push_back({edge, polytope.edges[edge][0] == from ? 1 : -1});
            from = to;
        }
    }
    return loops;
}

Polytope translated(Polytope polytope, Vec3 offset) {
    for (Vec3& vertex : polytope.vertices) vertex += offset;
    for (Plane& plane : polytope.planes) plane.offset += glm::dot(plane.normal, offset);
    return polytope;
}

Polytope placed(Polytope polytope, const Pose& pose) {
    for (Vec3& vertex : polytope.vertices) vertex = pose.position + pose.orientation * vertex;
    for (Plane& plane : polytope.planes) {
        plane.normal = pose.orientation * plane.normal;
        plane.offset += glm::dot(plane.normal, pose.position);
    }
    return polytope;
}

}  // namespace rubble
