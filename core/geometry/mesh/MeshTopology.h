#pragma once

#include "core/base/TaskContext.h"
#include "core/geometry/mesh/LatticeSurface.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// The triangles of a mesh that lie beside each other. Half-edges as in LatticeSurface.
struct EdgePairs {
    std::vector<std::uint32_t> across;   // kNone beside faulty edges
    std::vector<std::uint32_t> open;     // half-edges of edges with one triangle, ascending
    std::vector<std::uint32_t> crowded;  // the first half-edges of edges with more than two that cannot be paired
    std::vector<std::uint32_t> divided;  // the first half-edges of those with more than two that are

    std::size_t faultCount() const { return open.size() + crowded.size(); }
};

/// Finds the neighbours of triangles at edges. At an edge with more than two triangles those are neighbours that have
/// solid between them, if its triangles alternate: solids that share an edge come apart. `areInverted`: the triangles
/// are clockwise from outside. O(n log n).
///
/// Errors: Cancelled.
Result<EdgePairs> pairEdges(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                            const std::vector<Vec3>& onLattice, bool areInverted, const TaskContext& task);

/// How triangles have to be turned over to agree with their neighbours.
struct Windings {
    std::vector<char> turned;                // of each triangle; the fewer of a shell
    std::vector<std::uint32_t> shellOf;      // of each triangle; numbered by their first ones
    std::vector<std::uint32_t> conflicting;  // half-edges where they cannot agree, one of each edge, ascending
    std::uint32_t shellCount = 0;
};

/// Errors: Cancelled.
Result<Windings> agreeWindings(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                               const std::vector<std::uint32_t>& across, const TaskContext& task);

/// Triangles whose fans have points of their own.
struct SeparatedPoints {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> copied;  // the source of each additional point
};
/// Gives each fan of triangles around a point a point of its own, so that parts of a surface that share only corners or
/// edges come apart. Appends the points that are copied, by index; returns the corners' new points.
///
/// Errors: Cancelled.
Result<SeparatedPoints> separateFans(const LatticeSurface& surface, const TaskContext& task);

}  // namespace rubble
