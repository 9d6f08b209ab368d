#include "core/fracture/solid/ConcaveSplits.h"

#include "core/fracture/solid/SolidCut.h"
#include "core/fracture/solid/SolidHulls.h"
#include "core/geometry/hull/ConvexHull.h"
#include "core/geometry/hull/HullTriangles.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/mesh/SolidMesh.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

namespace rubble {
namespace {

struct HalfEdge {
    std::uint32_t low, high;
    std::uint32_t triangle;
};

/// The edges of the triangles, both sides of an edge beside each other.
std::vector<HalfEdge> halfEdges(const TriangleMesh& mesh) {
    std::vector<HalfEdge> edges;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), t});
        }
    }
    std::ranges::sort(edges, {}, [](const HalfEdge& e) { return std::tuple(e.low, e.high, e.triangle); });
    return edges;
}

/// A plane through a concave edge of a part, half-way between its two faces.
struct ConcaveEdge {
    Plane plane;
    double depth = 0.0;  // m, below the hull
    Vec3 middle{0.0};
};

/// How deep a point is below the surface of a hull.
double depthIn(const std::vector<Plane>& planes, Vec3 point) {
    double depth = std::numeric_limits<double>::infinity();
    for (const Plane& plane : planes) depth = std::min(depth, plane.offset - glm::dot(plane.normal, point));
    return depth;
}

/// The concave edges of a part that are below its hull, the deepest first; none when the task is cancelled.
std::vector<ConcaveEdge> concaveEdges(const TriangleMesh& mesh, const std::vector<Plane>& hull,
                                      const TaskContext& task) {
    constexpr std::size_t kBetweenLooks = 256;  // edges between two looks at whether the task is cancelled
    const std::vector<HalfEdge> edges = halfEdges(mesh);
    const double flat = 1e-6 * boundsOf(mesh).diagonal();
    std::vector<ConcaveEdge> concave;
    for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
        if (k % kBetweenLooks == 0 && task.isCancelled()) return {};
        const HalfEdge &first = edges[k], &second = edges[k + 1];
        if (first.low != second.low || first.high != second.high) continue;
        const Vec3 firstArea = doubleArea(mesh, first.triangle), secondArea = doubleArea(mesh, second.triangle);
        if (firstArea == Vec3(0.0) || secondArea == Vec3(0.0)) continue;  // without a normal
        const Vec3 n = glm::normalize(firstArea), m = glm::normalize(secondArea);
        const Vec3 a = mesh.points[first.low], b = mesh.points[first.high];
        double height = 0.0;  // of the second triangle's far corner over the first
        for (const std::uint32_t corner : mesh.triangles[second.triangle]) {
            if (corner != first.low && corner != first.high) height = glm::dot(n, mesh.points[corner] - a);
        }
        if (height <= flat || glm::length(n - m) < 1e-3) continue;
        const Vec3 normal = glm::normalize(n - m), middle = (a + b) / 2.0;
        const double depth = depthIn(hull, middle);
        if (depth > flat) concave.push_back({{normal, glm::dot(normal, a)}, depth, middle});
    }
    std::ranges::stable_sort(concave, std::greater{}, &ConcaveEdge::depth);
    return concave;
}

/// The planes to try: through the deepest edges, without those that are nearly the same.
std::vector<Plane> splittingPlanes(const TriangleMesh& mesh, const std::vector<Plane>& hull, int count,
                                   const TaskContext& task) {
    constexpr double kSameDirection = 0.95;  // the cosine of 18 degrees
    constexpr double kSamePlace = 0.02;      // of the diagonal
    const double near = kSamePlace * boundsOf(mesh).diagonal();
    std::vector<Plane> planes;
    for (const ConcaveEdge& edge : concaveEdges(mesh, hull, task)) {
        if (std::ssize(planes) == count) break;
        const auto isSame = [&](const Plane& plane) {
            return std::abs(glm::dot(plane.normal, edge.plane.normal)) > kSameDirection &&
                   std::abs(plane.offset - glm::dot(plane.normal, edge.middle)) < near;
        };
        if (std::ranges::none_of(planes, isSame)) planes.push_back(edge.plane);
    }
    return planes;
}

/// The parts of a mesh on both sides of a plane: its Voronoi cells of two points mirrored at it.
Result<std::vector<TriangleMesh>> split(const TriangleMesh& mesh, const Plane& plane, const TaskContext& task) {
    const Vec3 middle = boundsOf(mesh).centre();
    const Vec3 onPlane = middle + (plane.offset - glm::dot(plane.normal, middle)) * plane.normal;
    const Vec3 apart = boundsOf(mesh).diagonal() / 4.0 * plane.normal;
    const std::array<Vec3, 2> seeds = {onPlane - apart, onPlane + apart};
    const Result<SolidPartition> partition = cutSolid(mesh, seeds, task);
    if (!partition) return partition.error();
    std::vector<TriangleMesh> parts;
    for (std::uint32_t k = 0; k < partition->fragmentCount(); ++k) {
        if (task.isCancelled()) return TaskContext::cancelled();
        parts.push_back(meshOf(*partition, k));
        for (Vec3& point : parts.back().points) point += partition->origin;
    }
    return parts;
}

/// The volume of the convex hull of points, m³.
Result<double> hullVolume(std::span<const Vec3> points) {
    const Result<std::vector<HullTriangle>> hull = hullTriangles(points);
    if (!hull) return hull.error();
    double sixfold = 0.0;
    for (const HullTriangle& triangle : *hull) {
        const auto& [a, b, c] = triangle.corners;
        sixfold += glm::dot(points[a] - points[0], glm::cross(points[b] - points[0], points[c] - points[0]));
    }
    return sixfold / 6.0;
}

}  // namespace

Result<ConcaveSplits::Part> ConcaveSplits::partOf(TriangleMesh mesh, std::size_t madeBy) {
    const Result<double> around = hullVolume(mesh.points);
    if (!around) return around.error();
    const double excess = *around - massOf(mesh.points, mesh.triangles).volume;
    return Part{.mesh = std::move(mesh), .excess = excess, .madeBy = madeBy};
}

Result<ConcaveSplits> ConcaveSplits::of(TriangleMesh mesh, const SplitLimits& limits) {
    ConcaveSplits splits;
    splits.m_limits = limits;
    splits.m_volume = massOf(mesh.points, mesh.triangles).volume;
    Result<Part> whole = partOf(std::move(mesh), 0);
    if (!whole) return whole.error();
    splits.m_excesses.push_back(whole->excess);
    splits.m_partCounts.push_back(1);
    splits.m_parts.push_back(std::move(*whole));
    splits.m_isFinished = !splits.asksForMore();
    return splits;
}

Status ConcaveSplits::splitOnce(const TaskContext& task) {
    TaskContext silent = task;
    silent.threads = 1;
    silent.progress = {};
    for (const std::size_t before = splitCount(); splitCount() == before && !m_isFinished;) {
        const Status split = splitWorst(silent);
        m_isFinished = !split || !asksForMore();
        if (!split) return split;
    }
    return success();
}

bool ConcaveSplits::asksForMore() const {
    const auto isSplittable = [](const Part& part) { return !part.isFinal; };
    return m_excesses.back() > (m_limits.maxRatio - 1.0) * m_volume &&
           std::cmp_less(m_partCounts.back(), m_limits.maxParts) && std::ranges::any_of(m_parts, isSplittable);
}

/// Splits the part with the greatest excess, unless it is convex or its parts are too many.
Status ConcaveSplits::splitWorst(const TaskContext& task) {
    const auto worst = std::ranges::max_element(m_parts, {}, [](const Part& p) { return p.isFinal ? -1.0 : p.excess; });
    worst->isFinal = true;
    Result<std::vector<Part>> made = bestSplit(*worst, task);
    if (!made) return made.error();
    if (made->empty()) return success();
    worst->splitBy = m_excesses.size();
    double excess = m_excesses.back() - worst->excess;
    for (const Part& part : *made) excess += part.excess;
    m_excesses.push_back(excess);
    m_partCounts.push_back(m_partCounts.back() - 1 + made->size());
    std::ranges::move(*made, std::back_inserter(m_parts));
    return success();
}

/// The parts of a part; none if it is not split.
Result<std::vector<ConcaveSplits::Part>> ConcaveSplits::bestSplit(const Part& part, const TaskContext& task) const {
    const Result<Polytope> hull = convexHull(part.mesh.points, flatnessOf(part.mesh.points));
    if (!hull) return hull.error();
    if (task.isCancelled()) return TaskContext::cancelled();
    std::vector<Part> best;
    double most = 0.0;  // m³: what the best split saves for each part more
    // What takes more parts is a shell, of which each cut costs as much and saves little.
    constexpr std::size_t kMaxPartsOfFew = 3;
    const int candidates = m_partCounts.back() <= kMaxPartsOfFew ? m_limits.candidates : 1;
    for (const Plane& plane : splittingPlanes(part.mesh, hull->planes, candidates, task)) {
        Result<std::vector<TriangleMesh>> halves = split(part.mesh, plane, task);
        if (!halves) return halves.error();
        const std::size_t count = m_partCounts.back() - 1 + halves->size();
        if (halves->size() < 2 || std::cmp_greater(count, m_limits.maxParts)) continue;
        std::vector<Part> parts;
        double saved = part.excess;
        for (TriangleMesh& half : *halves) {
            Result<Part> next = partOf(std::move(half), m_excesses.size());
            if (!next) return next.error();
            saved -= next->excess;
            parts.push_back(std::move(*next));
        }
        saved /= static_cast<double>(parts.size() - 1);
        if (!best.empty() && saved <= most) continue;
        most = saved;
        best = std::move(parts);
    }
    if (task.isCancelled()) return TaskContext::cancelled();
    return best;
}

Result<std::vector<Polytope>> ConcaveSplits::hullsAfter(std::size_t splits) const {
    std::vector<Polytope> hulls;
    for (const Part& part : m_parts) {
        if (part.madeBy > splits || part.splitBy <= splits) continue;
        Result<Polytope> hull = convexHull(part.mesh.points, flatnessOf(part.mesh.points));
        if (!hull) return hull.error();
        hulls.push_back(std::move(*hull));
    }
    return hulls;
}

}  // namespace rubble
