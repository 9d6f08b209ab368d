#include "core/physics/shape/CoplanarFaces.h"

#include "core/base/Index.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace rubble {
namespace {

using Loop = std::vector<std::uint32_t>;
using Ends = std::pair<std::uint32_t, std::uint32_t>;
using Faces = std::map<Ends, std::uint32_t>;  // the face whose loop contains a directed edge

constexpr int kPlaneRounds = 3;

Vec3 doubleArea(const std::vector<Vec3>& vertices, const Loop& loop) {
    Vec3 area{0.0, 0.0, 0.0};
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
        area += glm::cross(vertices[loop[k]] - vertices[loop[0]], vertices[loop[k + 1]] - vertices[loop[0]]);
    }
    return area;
}

Faces facesOfEdges(const std::vector<Loop>& loops) {
    Faces faces;
    for (std::uint32_t face = 0; face < loops.size(); ++face) {
        const Loop& loop = loops[face];
        for (std::size_t k = 0; k < loop.size(); ++k) faces[{loop[k], loop[(k + 1) % loop.size()]}] = face;
    }
    return faces;
}

std::vector<std::uint32_t> largestFirst(const Polytope& polytope) {
    std::vector<double> areas;
    for (const Loop& loop : polytope.faces) areas.push_back(glm::length(doubleArea(polytope.vertices, loop)));
    std::vector<std::uint32_t> order(areas.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return areas[a] > areas[b]; });
    return order;
}

bool liesIn(const Polytope& polytope, std::uint32_t face, const Plane& plane, double tolerance) {
    const bool isNear = std::ranges::all_of(polytope.faces[face], [&](std::uint32_t vertex) {
        return std::abs(glm::dot(plane.normal, polytope.vertices[vertex]) - plane.offset) <= tolerance;
    });
    return isNear && glm::dot(polytope.planes[face].normal, plane.normal) > 0.0;
}

/// The connected faces without a group that lie in a plane, starting at `seed`.
std::vector<std::uint32_t> growRegion(const Polytope& polytope, const Faces& faces,
                                      const std::vector<std::uint32_t>& groups, std::uint32_t seed, const Plane& plane,
                                      double tolerance) {
    std::vector<std::uint32_t> members{seed};
    for (std::size_t next = 0; next < members.size(); ++next) {
        const Loop& loop = polytope.faces[members[next]];
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const std::uint32_t neighbour = faces.at({loop[(k + 1) % loop.size()], loop[k]});
            if (groups[neighbour] != kNone || std::ranges::find(members, neighbour) != members.end()) continue;
            if (liesIn(polytope, neighbour, plane, tolerance)) members.push_back(neighbour);
        }
    }
    return members;
}

/// The common plane of faces: across their mean normal, halfway between their highest and lowest vertex.
Plane planeOf(const Polytope& polytope, const std::vector<std::uint32_t>& members) {
    Vec3 area{0.0, 0.0, 0.0};
    for (const std::uint32_t face : members) area += doubleArea(polytope.vertices, polytope.faces[face]);
    const Vec3 normal = glm::normalize(area);
    double low = glm::dot(normal, polytope.vertices[polytope.faces[members[0]][0]]), high = low;
    for (const std::uint32_t face : members) {
        for (const std::uint32_t vertex : polytope.faces[face]) {
            low = std::min(low, glm::dot(normal, polytope.vertices[vertex]));
            high = std::max(high, glm::dot(normal, polytope.vertices[vertex]));
        }
    }
    return {normal, 0.5 * (low + high)};
}

/// The group of each face. Region growing, largest faces first; the plane is refitted after each round, since the plane
/// of a single face is inaccurate far from it.
std::vector<std::uint32_t> groupsOfFaces(const Polytope& polytope, const Faces& faces, double tolerance) {
    std::vector<std::uint32_t> groups(polytope.faces.size(), kNone);
    for (const std::uint32_t seed : largestFirst(polytope)) {
        if (groups[seed] != kNone) continue;
        std::vector<std::uint32_t> members{seed};
        Plane plane = polytope.planes[seed];
        for (int round = 0; round < kPlaneRounds; ++round) {
            members = growRegion(polytope, faces, groups, seed, plane, round == 0 ? 2.0 * tolerance : tolerance);
            if (members.size() == 1) break;
            plane = planeOf(polytope, members);
        }
        for (const std::uint32_t face : members) groups[face] = seed;
    }
    return groups;
}

/// The boundary edges of a group: from each vertex to the next.
using Boundary = std::map<std::uint32_t, std::uint32_t>;

/// The boundary of each group by its seed; nothing where one visits a vertex twice.
std::optional<std::map<std::uint32_t, Boundary>> boundariesOf(const Faces& faces,
                                                              const std::vector<std::uint32_t>& groups) {
    std::map<std::uint32_t, Boundary> boundaries;
    for (const auto& [ends, face] : faces) {
        if (groups[face] == groups[faces.at({ends.second, ends.first})]) continue;
        if (!boundaries[groups[face]].insert(ends).second) return std::nullopt;
    }
    return boundaries;
}

/// The boundary as a loop; nothing where it consists of several loops, or has fewer than three vertices left.
std::optional<Loop> loopAround(const Boundary& boundary, const std::vector<std::uint32_t>& newIndices) {
    Loop loop;
    std::size_t passed = 0;
    const std::uint32_t start = boundary.begin()->first;
    std::uint32_t corner = start;
    do {
        if (newIndices[corner] != kNone) loop.push_back(newIndices[corner]);
        corner = boundary.at(corner);
        ++passed;
    } while (corner != start && passed < boundary.size());
    if (corner != start || passed != boundary.size() || loop.size() < 3) return std::nullopt;
    return loop;
}

Plane planeOver(const std::vector<Vec3>& vertices, const Loop& loop) {
    const Vec3 normal = glm::normalize(doubleArea(vertices, loop));
    double offset = glm::dot(normal, vertices[0]);
    for (const Vec3& vertex : vertices) offset = std::max(offset, glm::dot(normal, vertex));
    return {normal, offset};
}

/// Adds the edges of the faces; false where the faces do not form a closed surface with Euler number two.
bool addEdges(Polytope& polytope) {
    const Faces faces = facesOfEdges(polytope.faces);
    for (const auto& [ends, face] : faces) {
        if (!faces.contains({ends.second, ends.first})) return false;
        if (ends.first < ends.second) polytope.edges.push_back({ends.first, ends.second});
    }
    return polytope.vertices.size() + polytope.faces.size() == polytope.edges.size() + 2;
}

std::optional<Polytope> merge(const Polytope& polytope, const std::map<std::uint32_t, Boundary>& boundaries) {
    std::vector<int> uses(polytope.vertices.size(), 0);
    for (const auto& [seed, boundary] : boundaries) {
        for (const auto& [from, to] : boundary) ++uses[from];
    }
    Polytope merged;
    std::vector<std::uint32_t> newIndices(polytope.vertices.size(), kNone);
    for (std::size_t vertex = 0; vertex < uses.size(); ++vertex) {
        if (uses[vertex] < 3) continue;
        newIndices[vertex] = static_cast<std::uint32_t>(merged.vertices.size());
        merged.vertices.push_back(polytope.vertices[vertex]);
    }
    for (const auto& [seed, boundary] : boundaries) {
        std::optional<Loop> loop = loopAround(boundary, newIndices);
        if (!loop) return std::nullopt;
        merged.faces.push_back(std::move(*loop));
    }
    for (const Loop& loop : merged.faces) merged.planes.push_back(planeOver(merged.vertices, loop));
    if (!addEdges(merged)) return std::nullopt;
    return merged;
}

}  // namespace

Polytope mergeCoplanarFaces(const Polytope& polytope, double tolerance) {
    const Faces faces = facesOfEdges(polytope.faces);
    const std::vector<std::uint32_t> groups = groupsOfFaces(polytope, faces, tolerance);
    bool isAnyMerged = false;
    for (std::uint32_t face = 0; face < groups.size(); ++face) isAnyMerged |= groups[face] != face;
    if (!isAnyMerged) return polytope;
    const auto boundaries = boundariesOf(faces, groups);
    std::optional<Polytope> merged = boundaries ? merge(polytope, *boundaries) : std::nullopt;
    return merged ? std::move(*merged) : polytope;
}

}  // namespace rubble
