#include "core/geometry/mesh/PreparedMesh.h"

#include "core/base/Index.h"
#include "core/base/Parallel.h"
#include "core/base/Random.h"
#include "core/geometry/mesh/MeshWelding.h"
#include "core/geometry/mesh/SolidLattice.h"
#include "core/geometry/mesh/SolidMesh.h"
#include "core/geometry/search/BoxTree.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <numeric>
#include <optional>

namespace rubble {
namespace {

constexpr std::size_t kBetweenLooks = 1u << 15;  // steps between two looks at the cancellation

bool isCancelledAt(std::size_t step, const TaskContext& task) {
    return step % kBetweenLooks == 0 && task.isCancelled();
}

/// For each point of a mesh, the one that it is taken for.
using Welding = std::vector<std::uint32_t>;

Welding byIndex(const TriangleMesh& mesh) {
    Welding welding(mesh.points.size());
    std::iota(welding.begin(), welding.end(), 0u);
    return welding;
}

/// Equal points are the first of them. Unfinished where cancelled.
Welding byPosition(const TriangleMesh& mesh, const TaskContext& task) {
    const std::size_t count = mesh.points.size();
    const int shift = 64 - std::max(1, static_cast<int>(std::bit_width(count / 2)));
    std::vector<std::uint32_t> buckets(count), first((std::size_t{1} << (64 - shift)) + 1, 0), sorted(count);
    for (std::uint32_t p = 0; p < count; ++p) {
        if (isCancelledAt(p, task)) return {};
        std::uint64_t bits = 0;
        for (int k = 0; k < 3; ++k)
            bits = mixSeeds(bits, std::bit_cast<std::uint64_t>(mesh.points[p][k] + 0.0));  // -0 is 0
        buckets[p] = static_cast<std::uint32_t>(bits >> shift);
        ++first[buckets[p] + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::uint32_t p = 0; p < count; ++p) {
        if (isCancelledAt(p, task)) return {};
        sorted[next[buckets[p]]++] = p;
    }
    Welding welding = byIndex(mesh);
    const std::size_t chunks = first.size() / kBetweenLooks + 1;
    forEachIndex(chunks, task.threads, [&](std::size_t chunk) {
        if (task.isCancelled()) return;
        const IndexRange range = chunkRange(first.size() - 1, chunk, chunks);
        for (std::size_t bucket = range.begin; bucket < range.end; ++bucket) {
            const std::span group = std::span(sorted).subspan(first[bucket], first[bucket + 1] - first[bucket]);
            std::ranges::sort(group, [&](std::uint32_t a, std::uint32_t b) {
                const Vec3 p = mesh.points[a], q = mesh.points[b];
                return p != q ? lexicographicLess(p, q) : a < b;
            });
            for (std::size_t k = 1; k < group.size(); ++k) {
                if (mesh.points[group[k - 1]] == mesh.points[group[k]]) welding[group[k]] = welding[group[k - 1]];
            }
        }
    });
    return welding;
}

/// Appends the points that triangles use, in their order, and renumbers the corners. Returns the new numbers, or kNone.
std::vector<std::uint32_t> keepUsedPoints(const TriangleMesh& mesh,
                                          std::vector<std::array<std::uint32_t, 3>>& triangles,
                                          std::vector<Vec3>& points) {
    std::vector<std::uint32_t> numbers(mesh.points.size(), kNone);
    for (const auto& triangle : triangles) {
        for (const std::uint32_t corner : triangle) numbers[corner] = 0;
    }
    for (std::uint32_t p = 0; p < numbers.size(); ++p) {
        if (numbers[p] == kNone) continue;
        numbers[p] = static_cast<std::uint32_t>(points.size());
        points.push_back(mesh.points[p]);
    }
    for (auto& triangle : triangles) {
        for (std::uint32_t& corner : triangle) corner = numbers[corner];
    }
    return numbers;
}

/// A prepared mesh by a welding; without the neighbours. Unfinished where cancelled.
PreparedMesh weldedBy(const TriangleMesh& mesh, const Welding& welding, const TaskContext& task) {
    PreparedMesh result;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (isCancelledAt(t, task)) return result;
        std::array<std::uint32_t, 3> corners = mesh.triangles[t];
        for (std::uint32_t& corner : corners) corner = welding[corner];
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
            result.dropped.push_back(t);
            continue;
        }
        result.mesh.triangles.push_back(corners);
        result.sources.push_back(t);
    }
    const std::vector<std::uint32_t> numbers = keepUsedPoints(mesh, result.mesh.triangles, result.mesh.points);
    for (std::uint32_t p = 0; p < welding.size(); ++p) {
        if (isCancelledAt(p, task)) return result;
        if (welding[p] == p || numbers[welding[p]] == kNone) continue;
        result.welded.push_back(p);
        result.maxWeldDistance =
            std::max(result.maxWeldDistance, glm::distance(mesh.points[p], mesh.points[welding[p]]));
    }
    return result;
}

Status findNeighbours(PreparedMesh& prepared, const TaskContext& task) {
    if (prepared.mesh.triangles.empty()) return success();
    const std::vector<Vec3>& points = prepared.mesh.points;
    const Box3 box = boundsOf(prepared.mesh);
    prepared.step = 1.0;
    prepared.onLattice.assign(points.size(), Vec3(0.0));
    if (box.diagonal() > 0.0) {
        const SolidLattice lattice(box);
        prepared.step = lattice.step();
        const std::size_t chunks = points.size() / kBetweenLooks + 1;
        forEachIndex(chunks, task.threads, [&](std::size_t chunk) {
            if (task.isCancelled()) return;
            const IndexRange range = chunkRange(points.size(), chunk, chunks);
            for (std::size_t p = range.begin; p < range.end; ++p) prepared.onLattice[p] = lattice.snapped(points[p]);
        });
    }
    if (task.isCancelled()) return TaskContext::cancelled();
    const bool areInverted = signedVolume(prepared.mesh) < 0.0;
    Result<EdgePairs> edges = pairEdges(prepared.mesh.triangles, prepared.onLattice, areInverted, task);
    if (!edges) return edges.error();
    prepared.edges = std::move(*edges);
    return success();
}

/// Points at open edges that are within the tolerance of another one are the first of them, too.
Welding byDistance(const TriangleMesh& mesh, const PreparedMesh& prepared, Welding welding, const TaskContext& task) {
    std::vector<std::uint32_t> points;
    for (const std::uint32_t h : prepared.edges.open) {
        const auto& corners = mesh.triangles[prepared.sources[h / 3]];
        points.push_back(welding[corners[h % 3]]);
        points.push_back(welding[corners[(h % 3 + 1) % 3]]);
    }
    std::ranges::sort(points);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    const double tolerance = meshTolerance(prepared.mesh);
    std::vector<Box3> boxes;
    for (const std::uint32_t point : points) boxes.push_back({mesh.points[point], mesh.points[point]});
    const BoxTree tree(boxes);
    Welding near = byIndex(mesh);
    for (const std::uint32_t point : points) {
        if (task.isCancelled()) break;
        if (near[point] != point) continue;
        const Vec3 place = mesh.points[point];
        tree.visitOverlapping({place - tolerance, place + tolerance}, [&](std::uint32_t item) {
            const std::uint32_t other = points[item];
            if (other > point && near[other] == other && glm::distance(mesh.points[other], place) <= tolerance)
                near[other] = point;
        });
    }
    for (std::uint32_t& point : welding) point = near[point];
    return welding;
}

}  // namespace

Result<PreparedMesh> preparedMesh(const TriangleMesh& mesh, const TaskContext& task) {
    std::optional<PreparedMesh> best;
    Welding welding = byIndex(mesh);
    for (int attempt = 0; attempt < 3; ++attempt) {
        if (attempt == 1) welding = byPosition(mesh, task);
        if (attempt == 2) welding = byDistance(mesh, *best, std::move(welding), task);
        if (task.isCancelled()) return TaskContext::cancelled();
        PreparedMesh next = weldedBy(mesh, welding, task);
        if (task.isCancelled()) return TaskContext::cancelled();
        if (const Status found = findNeighbours(next, task); !found) return found.error();
        const bool isBetter =
            !best || (!next.mesh.triangles.empty() && next.edges.faultCount() < best->edges.faultCount());
        if (isBetter) best = std::move(next);
        if (best->edges.faultCount() == 0) break;
    }
    return std::move(*best);
}

}  // namespace rubble
