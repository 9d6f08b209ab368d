#include "core/fracture/solid/SolidHulls.h"

#include "core/base/Parallel.h"
#include "core/base/Random.h"
#include "core/fracture/solid/SampledHulls.h"
#include "core/fracture/solid/SolidCut.h"
#include "core/geometry/hull/ConvexHull.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/mesh/SolidMesh.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace rubble {
namespace {

/// A part of a mesh with its hull.
struct HullPart {
    TriangleMesh mesh;
    Polytope hull;
    double volume = 0.0;   // m³
    double excess = 0.0;   // m³: of the hull over the part
    bool isFinal = false;  // it is not split
};

Result<HullPart> hullPart(TriangleMesh mesh) {
    constexpr double kFlat = 1e-10;  // of the part's size: what is flat but for the rounding of its points
    Result<Polytope> hull = convexHull(mesh.points, kFlat * boundsOf(mesh).diagonal());
    if (!hull) return hull.error();
    const double volume = massOf(mesh.points, mesh.triangles).volume, around = massOf(*hull).volume;
    return HullPart{std::move(mesh), std::move(*hull), volume, around - volume};
}

/// How deep a point is below the surface of a hull, if deeper than `least`; else that or less, in less time. `nearest`:
/// the face to try first, which becomes the nearest one.
double depthIn(const Polytope& hull, Vec3 point, double least, std::size_t& nearest) {
    const auto depthBelow = [&](const Plane& plane) { return plane.offset - glm::dot(plane.normal, point); };
    double depth = depthBelow(hull.planes[nearest]);
    for (std::size_t k = 0; k < hull.planes.size() && depth > least; ++k) {
        const double below = depthBelow(hull.planes[k]);
        if (below < depth) depth = below, nearest = k;
    }
    return depth;
}

/// The plane through the deepest concave edge of a part, half-way between its two faces; nothing for a convex part.
std::optional<Plane> splittingPlane(const HullPart& part) {
    struct HalfEdge {
        std::uint32_t low, high;
        std::uint32_t triangle;
    };
    const TriangleMesh& mesh = part.mesh;
    std::vector<HalfEdge> edges;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), t});
        }
    }
    std::ranges::sort(edges, {}, [](const HalfEdge& e) { return std::tuple(e.low, e.high, e.triangle); });
    const double flat = 1e-6 * boundsOf(mesh).diagonal();
    double deepest = flat;
    std::size_t nearest = 0;
    std::optional<Plane> best;
    for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
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
        if (height <= flat) continue;
        const double depth = depthIn(part.hull, (a + b) / 2.0, deepest, nearest);
        const Vec3 normal = n - m;
        if (depth <= deepest || glm::length(normal) < 1e-3) continue;
        deepest = depth;
        best = Plane{glm::normalize(normal), glm::dot(glm::normalize(normal), a)};
    }
    return best;
}

/// The parts of a mesh on both sides of a plane: its Voronoi cells of two points mirrored at it.
Result<std::vector<TriangleMesh>> split(const TriangleMesh& mesh, const Plane& plane) {
    const Vec3 middle = boundsOf(mesh).centre();
    const Vec3 onPlane = middle + (plane.offset - glm::dot(plane.normal, middle)) * plane.normal;
    const Vec3 apart = boundsOf(mesh).diagonal() / 4.0 * plane.normal;
    const std::array<Vec3, 2> seeds = {onPlane - apart, onPlane + apart};
    const Result<SolidPartition> partition = cutSolid(mesh, seeds);
    if (!partition) return partition.error();
    std::vector<TriangleMesh> parts;
    for (std::uint32_t k = 0; k < partition->fragmentCount(); ++k) {
        parts.push_back(meshOf(*partition, k));
        for (Vec3& point : parts.back().points) point += partition->origin;
    }
    return parts;
}

}  // namespace

TriangleMesh meshOf(const SolidPartition& partition, std::uint32_t fragment) {
    TriangleMesh mesh;
    std::vector<std::uint32_t> used;
    for (const SolidPartition::FaceSide& side : partition.facesOf(fragment)) {
        for (std::array<std::uint32_t, 3> triangle : partition.trianglesOf(side.face)) {
            if (side.isReversed) std::swap(triangle[1], triangle[2]);
            mesh.triangles.push_back(triangle);
            used.insert(used.end(), triangle.begin(), triangle.end());
        }
    }
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
        for (std::uint32_t& point : triangle) {
            point = static_cast<std::uint32_t>(std::ranges::lower_bound(used, point) - used.begin());
        }
    }
    for (const std::uint32_t point : used) mesh.points.push_back(partition.points[point]);
    return mesh;
}

Result<std::vector<Polytope>> hullsOf(const TriangleMesh& mesh, const HullLimits& limits) {
    Result<HullPart> whole = hullPart(mesh);
    if (!whole) return whole.error();
    const double allowed = (limits.maxRatio - 1.0) * whole->volume;
    std::vector<HullPart> parts;
    parts.push_back(std::move(*whole));
    const auto totalExcess = [&] {
        return std::accumulate(parts.begin(), parts.end(), 0.0,
                               [](double sum, const HullPart& p) { return sum + p.excess; });
    };
    while (totalExcess() > allowed && static_cast<int>(parts.size()) < limits.maxHulls) {
        const auto worst =
            std::ranges::max_element(parts, {}, [](const HullPart& p) { return p.isFinal ? -1.0 : p.excess; });
        if (worst->isFinal) break;
        worst->isFinal = true;
        const std::optional<Plane> plane = splittingPlane(*worst);
        if (!plane) continue;
        Result<std::vector<TriangleMesh>> halves = split(worst->mesh, *plane);
        if (!halves) return halves.error();
        if (halves->size() < 2 || parts.size() - 1 + halves->size() > static_cast<std::size_t>(limits.maxHulls))
            continue;
        parts.erase(worst);
        for (TriangleMesh& half : *halves) {
            Result<HullPart> next = hullPart(std::move(half));
            if (!next) return next.error();
            parts.push_back(std::move(*next));
        }
    }
    std::vector<Polytope> hulls;
    for (HullPart& part : parts) hulls.push_back(std::move(part.hull));
    return hulls;
}

std::vector<Result<std::vector<Polytope>>> hullsOfEach(std::size_t count,
                                                       const std::function<TriangleMesh(std::uint32_t)>& meshOf,
                                                       const HullLimits& limits, const TaskContext& task) {
    std::vector<Result<std::vector<Polytope>>> hulls(count, Result<std::vector<Polytope>>(std::vector<Polytope>{}));
    forEachIndex(count, task.threads, [&](std::size_t k) {
        if (!task.isCancelled()) hulls[k] = hullsOf(meshOf(static_cast<std::uint32_t>(k)), limits);
    });
    return hulls;
}

Result<std::vector<std::vector<Polytope>>> fragmentHulls(const SolidPartition& partition, const HullLimits& limits,
                                                         const TaskContext& task) {
    std::vector<Result<std::vector<Polytope>>> each = hullsOfEach(
        partition.fragmentCount(), [&](std::uint32_t fragment) { return meshOf(partition, fragment); }, limits, task);
    if (task.isCancelled()) return TaskContext::cancelled();
    std::vector<std::vector<Polytope>> hulls;
    for (std::size_t fragment = 0; fragment < each.size(); ++fragment) {
        if (!each[fragment]) {
            return Error{each[fragment].error().code,
                         "Fragment " + std::to_string(fragment) + " has no hull: " + each[fragment].error().message};
        }
        hulls.push_back(std::move(*each[fragment]));
    }
    return hulls;
}

Result<std::vector<Polytope>> coarseHulls(const TriangleMesh& mesh, int cells, const TaskContext& task) {
    constexpr int kRelaxations = 4;
    constexpr std::size_t kMaxExact = 30'000;  // triangles that are cut again for each relaxation
    if (mesh.triangles.size() > kMaxExact) return sampledHulls(mesh, cells, task);
    const Box3 box = boundsOf(mesh);
    Random random(mixSeeds(static_cast<std::uint64_t>(cells), mesh.triangles.size()));
    std::vector<Vec3> seeds;
    for (int k = 0; k < cells; ++k) {
        const double x = random.between(box.min.x, box.max.x), y = random.between(box.min.y, box.max.y);
        seeds.push_back({x, y, random.between(box.min.z, box.max.z)});
    }
    for (int round = 0;; ++round) {
        const Result<SolidPartition> partition = cutSolid(mesh, seeds, task);
        if (!partition) return partition.error();
        if (round == kRelaxations) {
            const Result<std::vector<std::vector<Polytope>>> hulls = fragmentHulls(*partition, {}, task);
            if (!hulls) return hulls.error();
            std::vector<Polytope> all;
            for (const std::vector<Polytope>& some : *hulls) {
                for (const Polytope& hull : some) all.push_back(translated(hull, partition->origin));
            }
            return all;
        }
        seeds.clear();
        for (std::uint32_t k = 0; k < partition->fragmentCount(); ++k) {
            const TriangleMesh part = meshOf(*partition, k);
            seeds.push_back(partition->origin + massOf(part.points, part.triangles).centre);
        }
    }
}

}  // namespace rubble
