#pragma once

#include "core/base/Index.h"
#include "core/base/TaskContext.h"
#include "core/geometry/mesh/TriangleTree.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rubble {

/// A connected closed surface of a mesh.
struct MeshShell {
    std::uint32_t firstTriangle = 0;
    std::size_t triangleCount = 0;
    double volume = 0.0;           // m³; negative around a cavity
    double area = 0.0;             // m²
    std::uint32_t around = kNone;  // the innermost shell that it is inside of
    std::uint32_t part = 0;        // solid that it bounds, numbered by their first triangles
    bool isCavity() const { return volume < 0.0; }
};

/// The shells of a surface, how they are nested, and which of them have to be turned inside out.
struct ShellNesting {
    std::vector<MeshShell> shells;  // by first triangle
    std::vector<char> turned;       // of each shell: an outer one was clockwise; volumes are those after it
    std::vector<std::array<std::uint32_t, 2>> overlapping;  // {shell, the one around it} that are solid both
    std::uint32_t partCount = 0;
};

/// Measures the shells of a surface, finds which is inside which, and turns outer ones whose triangles are clockwise
/// from outside, with all shells in them. `shellOf`: of each triangle; `points`: m. Where shells cross, the result is
/// any. O(n log n) for n triangles, and O(log n) plus the number of crossed triangles for each shell.
///
/// Errors: Cancelled.
Result<ShellNesting> nestShells(const LatticeSurface& surface, const std::vector<Vec3>& points,
                                const std::vector<std::uint32_t>& shellOf, const TriangleTree& tree,
                                const TaskContext& task);

}  // namespace rubble
