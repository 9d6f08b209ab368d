#include "core/geometry/mesh/MeshWelding.h"

#include "core/base/Index.h"
#include "core/base/Random.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

namespace rubble {
namespace {

/// The kept points in a hash grid, with cells of eight tolerances, so that a query rarely visits more than one cell.
class PointGrid {
public:
    explicit PointGrid(double tolerance) : m_tolerance(tolerance), m_width(8.0 * tolerance) {}

    /// The nearest kept point within the tolerance, the first of equidistant ones, or kNone.
    std::uint32_t nearest(Vec3 point, const std::vector<Vec3>& kept) const {
        std::uint32_t best = kNone;
        double bestDistance = m_tolerance;
        const Vec3 low = cell(point - m_tolerance), high = cell(point + m_tolerance);
        for (double x = low.x; x <= high.x; ++x)
            for (double y = low.y; y <= high.y; ++y)
                for (double z = low.z; z <= high.z; ++z) {
                    const auto found = m_cells.find(key({x, y, z}));
                    if (found == m_cells.end()) continue;
                    for (const std::uint32_t index : found->second) {
                        const double distance = glm::distance(point, kept[index]);
                        if (distance > bestDistance || (distance == bestDistance && index > best)) continue;
                        best = index;
                        bestDistance = distance;
                    }
                }
        return best;
    }
    void add(Vec3 point, std::uint32_t index) { m_cells[key(cell(point))].push_back(index); }

private:
    Vec3 cell(Vec3 point) const { return glm::floor(point / m_width); }
    /// Hash collisions are harmless: distances are compared.
    static std::uint64_t key(Vec3 cell) {
        std::uint64_t bits = 0;
        for (int k = 0; k < 3; ++k)
            bits = mixSeeds(bits, static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[k])));
        return bits;
    }

    double m_tolerance;
    double m_width;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> m_cells;
};

std::optional<Error> faultOf(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) return Error{ErrorCode::BadInput, "The mesh has no triangle."};
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (const std::uint32_t corner : mesh.triangles[i]) {
            if (corner < mesh.points.size()) continue;
            return Error{ErrorCode::BadInput, "Triangle " + std::to_string(i) + " refers to point " +
                                                  std::to_string(corner) + " of " + std::to_string(mesh.points.size()) +
                                                  "."};
        }
    }
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        const Vec3 size = glm::abs(mesh.points[i]);
        if (size.x < kMaxMeshCoordinate && size.y < kMaxMeshCoordinate && size.z < kMaxMeshCoordinate) continue;
        const bool isFinite = std::isfinite(size.x) && std::isfinite(size.y) && std::isfinite(size.z);
        return Error{ErrorCode::BadInput,
                     "Point " + std::to_string(i) + " of the mesh is " +
                         (isFinite ? "out of range: 1e30 m or more from the origin." : "not a finite number.")};
    }
    return std::nullopt;
}

}  // namespace

double meshTolerance(const TriangleMesh& mesh) {
    const Box3 box = boundsOf(mesh);
    if (mesh.points.empty()) return 0.0;
    const Vec3 farthest = glm::max(glm::abs(box.min), glm::abs(box.max));
    const double singlePrecision = 0x1p-24 * std::max({farthest.x, farthest.y, farthest.z});
    return std::max(kRelativeMeshTolerance * box.diagonal(), 4.0 * singlePrecision);
}

Result<WeldedMesh> welded(const TriangleMesh& mesh) {
    if (const std::optional<Error> fault = faultOf(mesh)) return *fault;
    WeldedMesh result;
    result.tolerance = meshTolerance(mesh);
    if (!(result.tolerance > 0.0)) return Error{ErrorCode::Degenerate, "The mesh is a single point."};
    PointGrid grid(result.tolerance);
    std::vector<Vec3>& kept = result.mesh.points;
    std::vector<std::uint32_t> merged(mesh.points.size(), kNone);
    const auto mergedPoint = [&](std::uint32_t index) {
        if (merged[index] != kNone) return merged[index];
        const Vec3 point = mesh.points[index];
        merged[index] = grid.nearest(point, kept);
        if (merged[index] == kNone) {
            merged[index] = static_cast<std::uint32_t>(kept.size());
            grid.add(point, merged[index]);
            kept.push_back(point);
        } else if (kept[merged[index]] != point) {
            ++result.mergedPoints;
            result.maxMergeDistance = std::max(result.maxMergeDistance, glm::distance(point, kept[merged[index]]));
        }
        return merged[index];
    };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto [a, b, c] = mesh.triangles[i];
        const std::array<std::uint32_t, 3> triangle{mergedPoint(a), mergedPoint(b), mergedPoint(c)};
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) {
            ++result.droppedTriangles;
            continue;
        }
        result.mesh.triangles.push_back(triangle);
        result.sources.push_back(static_cast<std::uint32_t>(i));
    }
    if (result.mesh.triangles.empty()) return Error{ErrorCode::Degenerate, "No triangle of the mesh has an area."};
    return result;
}

}  // namespace rubble
