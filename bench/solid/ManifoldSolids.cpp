#include "bench/solid/SolidPeers.h"

#ifdef RUBBLE_HAS_MANIFOLD
#include "core/base/Parallel.h"

#include <manifold/manifold.h>

namespace rubble::bench {
namespace {

manifold::Manifold manifoldOf(const TriangleMesh& mesh) {
    manifold::MeshGL64 result;
    result.numProp = 3;
    for (const Vec3 point : mesh.points)
        result.vertProperties.insert(result.vertProperties.end(), {point.x, point.y, point.z});
    for (const auto& [a, b, c] : mesh.triangles) result.triVerts.insert(result.triVerts.end(), {a, b, c});
    return manifold::Manifold(result);
}

CutSum sumOf(std::span<const double> volumes) {
    CutSum sum;
    for (const double volume : volumes) {
        sum.cells += volume > 0.0;
        sum.volume += volume;
    }
    return sum;
}

}  // namespace

bool hasManifold() { return true; }

CutSum intersectedByManifold(const TriangleMesh& mesh, std::span<const ConvexCell> cells, int threads) {
    const manifold::Manifold whole = manifoldOf(mesh);
    std::vector<double> volumes(cells.size());
    forEachIndex(cells.size(), threads, [&](std::size_t k) {
        std::vector<manifold::vec3> corners;
        for (const Vec3 corner : cells[k].corners) corners.emplace_back(corner.x, corner.y, corner.z);
        volumes[k] = (whole ^ manifold::Manifold::Hull(corners)).Volume();
    });
    return sumOf(volumes);
}

CutSum splitByManifold(const TriangleMesh& mesh, std::span<const ConvexCell> cells) {
    const manifold::Manifold whole = manifoldOf(mesh);
    std::vector<double> volumes;
    for (const ConvexCell& cell : cells) {
        manifold::Manifold part = whole;
        for (const CellPlane& plane : cell.planes) {
            part = part.TrimByPlane({-plane.normal.x, -plane.normal.y, -plane.normal.z}, -plane.offset);
        }
        volumes.push_back(part.Volume());
    }
    return sumOf(volumes);
}

}  // namespace rubble::bench
#else
namespace rubble::bench {

bool hasManifold() { return false; }
CutSum intersectedByManifold(const TriangleMesh&, std::span<const ConvexCell>, int) { return {}; }
CutSum splitByManifold(const TriangleMesh&, std::span<const ConvexCell>) { return {}; }

}  // namespace rubble::bench
#endif
