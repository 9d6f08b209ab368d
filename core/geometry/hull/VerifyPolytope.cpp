#include "core/geometry/hull/Polytope.h"
#include "core/geometry/predicates/Predicates.h"
#include "core/geometry/search/BoxTree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace rubble {

namespace {

using Fault = std::optional<std::string>;
using Ends = std::pair<std::uint32_t, std::uint32_t>;

constexpr double kPlanar = 1e-9;     // tolerance of planarity, relative to the polytope's size
constexpr double kRoundOff = 1e-14;  // rounding error of coordinates far from the origin, relative to them

std::string face(std::size_t index) { return "Face " + std::to_string(index); }
std::string edge(Ends ends) { return std::to_string(ends.first) + "-" + std::to_string(ends.second); }

bool isFinite(Vec3 point) { return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z); }

Fault indexFault(const Polytope& polytope) {
    const std::size_t count = polytope.vertices.size();
    if (polytope.planes.size() != polytope.faces.size()) {
        return std::to_string(polytope.faces.size()) + " faces have " + std::to_string(polytope.planes.size()) +
               " planes.";
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (!isFinite(polytope.vertices[i])) return "Vertex " + std::to_string(i) + " is not finite.";
    }
    for (std::size_t i = 0; i < polytope.edges.size(); ++i) {
        const auto [a, b] = polytope.edges[i];
        if (a >= count || b >= count || a == b)
            return "Edge " + std::to_string(i) + " does not have two valid vertices.";
    }
    for (std::size_t i = 0; i < polytope.faces.size(); ++i) {
        if (polytope.faces[i].size() < 3) return face(i) + " has fewer than three corners.";
        for (const std::uint32_t vertex : polytope.faces[i]) {
            if (vertex >= count)
                return face(i) + " refers to vertex " + std::to_string(vertex) + ", which does not exist.";
        }
    }
    return std::nullopt;
}

/// Every edge must be listed once and used once in each direction by faces.
Fault closureFault(const Polytope& polytope) {
    std::map<Ends, int> uses;
    for (std::size_t i = 0; i < polytope.faces.size(); ++i) {
        const std::vector<std::uint32_t>& loop = polytope.faces[i];
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Ends ends{loop[k], loop[(k + 1) % loop.size()]};
            if (++uses[ends] > 1) return "Edge " + edge(ends) + " is used twice in the same direction.";
        }
    }
    std::map<Ends, int> listed;
    for (const auto& [a, b] : polytope.edges) {
        if (++listed[std::minmax(a, b)] > 1) return "Edge " + edge(std::minmax(a, b)) + " is listed twice.";
        if (!uses.count({a, b}) || !uses.count({b, a})) return "Edge " + edge({a, b}) + " does not have two faces.";
    }
    for (const auto& [ends, count] : uses) {
        if (!listed.count(std::minmax(ends.first, ends.second))) return "Edge " + edge(ends) + " is not listed.";
    }
    return std::nullopt;
}

Fault eulerFault(const Polytope& polytope) {
    const auto count = [](const auto& list) { return static_cast<long>(list.size()); };
    const long euler = count(polytope.vertices) - count(polytope.edges) + count(polytope.faces);
    if (euler == 2) return std::nullopt;
    return "The Euler number is " + std::to_string(euler) + " instead of 2.";
}

/// Accurate also for needles, whose corners are nearly collinear.
Vec3 loopNormal(const Polytope& polytope, const std::vector<std::uint32_t>& loop) {
    const Vec3 origin = polytope.vertices[loop[0]];
    Vec3 normal{0.0, 0.0, 0.0};
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
        normal += exactCross(origin, polytope.vertices[loop[k]], polytope.vertices[loop[k + 1]]);
    }
    return normal;
}

double tolerance(const Polytope& polytope) {
    Vec3 low = polytope.vertices[0];
    Vec3 high = low;
    for (const Vec3& vertex : polytope.vertices) {
        low = glm::min(low, vertex);
        high = glm::max(high, vertex);
    }
    return kPlanar * glm::length(high - low) + kRoundOff * glm::length(glm::max(glm::abs(low), glm::abs(high)));
}

/// Finds vertices in front of planes.
class FrontSearch {
public:
    explicit FrontSearch(const Polytope& polytope) : m_polytope(polytope) {
        if (polytope.vertices.size() < kSearchedVertices) return;
        std::vector<Box3> boxes;
        boxes.reserve(polytope.vertices.size());
        for (const Vec3& vertex : polytope.vertices) boxes.push_back({vertex, vertex});
        m_tree.emplace(boxes);
    }

    /// The first vertex more than `most` in front of a plane that is finite. O(log n) unless many are near it.
    std::optional<std::uint32_t> first(const Plane& plane, double most) const {
        std::optional<std::uint32_t> found;
        const auto test = [&](std::uint32_t vertex) {
            const bool isInFront = !(glm::dot(plane.normal, m_polytope.vertices[vertex]) - plane.offset <= most);
            if (isInFront && !(found && *found < vertex)) found = vertex;
        };
        // A millionth less, which is far above the rounding of the sum.
        if (m_tree) m_tree->visitBeyond(plane.normal, plane.offset + most * (1.0 - 1e-6), test);
        for (std::uint32_t vertex = 0; !m_tree && !found && vertex < m_polytope.vertices.size(); ++vertex) test(vertex);
        return found;
    }

private:
    static constexpr std::size_t kSearchedVertices = 64;  // of fewer, a tree takes longer than it saves

    const Polytope& m_polytope;
    std::optional<BoxTree> m_tree;
};

Fault shapeFault(const Polytope& polytope) {
    const double most = tolerance(polytope);
    const FrontSearch front(polytope);
    for (std::size_t i = 0; i < polytope.faces.size(); ++i) {
        const Plane& plane = polytope.planes[i];
        if (!(std::abs(glm::length(plane.normal) - 1.0) < 1e-9))
            return face(i) + " has a normal whose length is not 1.";
        if (!(glm::dot(loopNormal(polytope, polytope.faces[i]), plane.normal) > 0.0)) {
            return face(i) + " is not counter-clockwise about its normal.";
        }
        for (const std::uint32_t vertex : polytope.faces[i]) {
            const double height = glm::dot(plane.normal, polytope.vertices[vertex]) - plane.offset;
            if (!(std::abs(height) <= most)) {
                return face(i) + " is not planar: vertex " + std::to_string(vertex) + " is off its plane.";
            }
        }
        if (const auto vertex = front.first(plane, most)) {
            return face(i) + " faces inward or is not convex: vertex " + std::to_string(*vertex) +
                   " is in front of it.";
        }
    }
    return std::nullopt;
}

}  // namespace

Fault verifyPolytope(const Polytope& polytope) {
    if (polytope.vertices.size() < 4) return "There are fewer than four vertices.";
    if (Fault fault = indexFault(polytope)) return fault;
    if (Fault fault = closureFault(polytope)) return fault;
    if (Fault fault = eulerFault(polytope)) return fault;
    return shapeFault(polytope);
}

}  // namespace rubble
