#include "core/fracture/solid/SolidCut.h"

#include "core/base/Parallel.h"
#include "core/fracture/solid/SolidPlacement.h"
#include "core/fracture/solid/SolidPoints.h"
#include "core/fracture/solid/SolidShells.h"
#include "core/geometry/mesh/MeshWelding.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace rubble {
namespace {

class PartitionWriter {
public:
    PartitionWriter(const SolidDiagram& diagram, const SolidFaces& faces, const SolidShells& shells,
                    const SolidPoints& points, const TaskContext& task)
        : m_diagram(diagram),
          m_faces(faces),
          m_shells(shells),
          m_onLattice(points.onLattice),
          m_placed(points.placed),
          m_task(task) {}

    /// Incomplete if the task is cancelled.
    SolidPartition write(std::size_t seedCount, const SolidLattice& lattice) {
        numberFragments(seedCount);
        addFaces();
        if (m_task.isCancelled()) return {};
        m_result.listFaces();
        m_result.origin = lattice.origin();
        m_result.points.reserve(m_placed.size());
        for (const Vec3 point : m_placed) m_result.points.push_back(lattice.metres(point));
        m_result.volumes.resize(m_result.fragmentCount());
        forEachIndex(m_result.fragmentCount(), m_task.threads, [this](std::size_t fragment) {
            m_result.volumes[fragment] = m_result.volumeOf(static_cast<std::uint32_t>(fragment));
        });
        m_result.duplicates = m_diagram.sites().duplicates;
        return std::move(m_result);
    }

private:
    void numberFragments(std::size_t seedCount) {
        std::vector<std::uint32_t> owners;
        for (std::uint32_t s = 0; s < m_shells.shells.size(); ++s) {
            if (m_shells.shells[s].owner == s) owners.push_back(s);
        }
        const auto seedOf = [&](std::uint32_t shell) { return m_diagram.sites().seedOf[m_shells.shells[shell].cell]; };
        std::sort(owners.begin(), owners.end(), [&](std::uint32_t a, std::uint32_t b) {
            if (seedOf(a) != seedOf(b)) return seedOf(a) < seedOf(b);
            const Vec3 p = m_onLattice[m_shells.shells[a].smallest], q = m_onLattice[m_shells.shells[b].smallest];
            return p != q ? lexicographicLess(p, q) : m_shells.shells[a].smallest < m_shells.shells[b].smallest;
        });
        m_fragmentOfShell.assign(m_shells.shells.size(), kNone);
        m_result.fragmentOfSeed.assign(seedCount, kNone);
        for (std::uint32_t fragment = 0; fragment < owners.size(); ++fragment) {
            m_fragmentOfShell[owners[fragment]] = fragment;
            const std::uint32_t seed = seedOf(owners[fragment]);
            m_result.seedOfFragment.push_back(seed);
            if (m_result.fragmentOfSeed[seed] == kNone) m_result.fragmentOfSeed[seed] = fragment;
            const std::uint32_t part = fragment - m_result.fragmentOfSeed[seed];
            const bool hasNext = fragment + 1 < owners.size() && seedOf(owners[fragment + 1]) == seed;
            m_result.partOfFragment.push_back(part > 0 || hasNext ? part : kNone);
        }
        for (std::uint32_t s = 0; s < m_shells.shells.size(); ++s) {
            const std::uint32_t owner = m_shells.ownerOf(s);
            if (owner != kNone) m_fragmentOfShell[s] = m_fragmentOfShell[owner];
        }
    }

    /// Names the fragments of faces, and drops faces within one fragment.
    void addFaces() {
        m_result.firstTriangle.assign(1, 0);
        m_result.faces.reserve(m_faces.faceCount());
        m_result.firstTriangle.reserve(m_faces.faceCount() + 1);
        m_result.triangles.reserve(m_faces.triangles.size());
        for (std::uint32_t f = 0; f < m_faces.faceCount() && !m_task.isCancelled(); ++f) {
            SolidPartition::Face face = m_faces.faces[f];
            face.fragment = m_fragmentOfShell[m_shells.ofSide[2 * f]];
            if (face.behind != kNone) face.behind = m_fragmentOfShell[m_shells.ofSide[2 * f + 1]];
            if (face.fragment == face.behind || face.fragment == kNone) continue;
            m_result.addFace(face, m_faces.trianglesOf(f));
        }
    }

    const SolidDiagram& m_diagram;
    const SolidFaces& m_faces;
    const SolidShells& m_shells;
    std::span<const Vec3> m_onLattice, m_placed;  // points, in steps
    const TaskContext& m_task;
    std::vector<std::uint32_t> m_fragmentOfShell;
    SolidPartition m_result;
};

/// Why something cannot be on a lattice at all; nothing if it can.
std::optional<std::string> inputFault(const TriangleMesh& mesh, std::span<const Vec3> seeds) {
    if (seeds.empty()) return "There is no seed.";
    if (mesh.triangles.empty()) return "The mesh has no triangles.";
    const auto isUsable = [](Vec3 point) {
        const Vec3 size = glm::abs(point);  // comparisons are false for what is not a number
        return size.x < kMaxMeshCoordinate && size.y < kMaxMeshCoordinate && size.z < kMaxMeshCoordinate;
    };
    for (std::size_t k = 0; k < mesh.points.size(); ++k) {
        if (!isUsable(mesh.points[k]))
            return "Point " + std::to_string(k) + " of the mesh is not finite or too far out.";
    }
    for (std::size_t k = 0; k < seeds.size(); ++k) {
        if (!isUsable(seeds[k])) return "Seed " + std::to_string(k) + " is not finite or too far out.";
    }
    return std::nullopt;
}

/// Corners of a mesh on a lattice, in steps.
LatticeMesh snappedMesh(const TriangleMesh& mesh, const SolidLattice& lattice, const TaskContext& task) {
    LatticeMesh snapped;
    snapped.corners.reserve(mesh.points.size());
    for (const Vec3 point : mesh.points) snapped.corners.push_back(lattice.snapped(point));
    snapped.triangles = mesh.triangles;
    findEdges(snapped, task);
    return snapped;
}

}  // namespace

Result<SolidPartition> cutSolid(const TriangleMesh& mesh, std::span<const Vec3> seeds, const TaskContext& task) {
    if (const std::optional<std::string> fault = inputFault(mesh, seeds)) return Error{ErrorCode::BadInput, *fault};
    Box3 box = boundsOf(mesh);
    for (const Vec3 seed : seeds) box.include(seed);
    const SolidLattice lattice(box);
    const LatticeMesh snapped = snappedMesh(mesh, lattice, task);
    if (task.isCancelled()) return TaskContext::cancelled();
    task.report(0.1);
    std::vector<Vec3> sites;
    for (const Vec3 seed : seeds) sites.push_back(lattice.snapped(seed));
    Result<Tetrahedralization> triangulation = tetrahedralized(sites, task.stage(0.1, 0.3));
    if (!triangulation) return triangulation.error();
    const SolidDiagram diagram(std::move(*triangulation), task);
    if (task.isCancelled()) return TaskContext::cancelled();
    task.report(0.3);
    const Result<SurfacePieces> pieces = walkSurface(snapped, diagram, task);
    if (!pieces) return pieces.error();
    task.report(0.5);
    const Result<InnerFaces> facets = innerFaces(snapped, diagram, *pieces, task);
    if (!facets) return facets.error();
    task.report(0.55);
    std::vector<Vec3> corners;
    corners.reserve(mesh.points.size());
    for (const Vec3 point : mesh.points) corners.push_back(lattice.steps(point));
    Result<SolidPoints> points = solidPoints(snapped, corners, diagram, *pieces, *facets, task);
    if (!points) return points.error();
    std::vector<Vec3> given;  // sites where they are
    for (std::uint32_t site = 0; site < diagram.siteCount(); ++site) {
        given.push_back(lattice.steps(seeds[diagram.sites().seedOf[site]]));
    }
    placeBetweenSeeds(snapped, corners, given, diagram, *pieces, *facets, points->placed);
    task.report(0.6);
    const Result<SolidFaces> faces = solidFaces(snapped, diagram, *pieces, *facets, points->onLattice, task);
    if (!faces) return faces.error();
    placeOnSurface(snapped, corners, *pieces, faces->welded, points->placed);
    task.report(0.8);
    const Result<SolidShells> shells = solidShells(*faces, points->onLattice, task);
    if (!shells) return shells.error();
    task.report(0.95);
    SolidPartition partition = PartitionWriter(diagram, *faces, *shells, *points, task).write(seeds.size(), lattice);
    if (task.isCancelled()) return TaskContext::cancelled();
    task.report(1.0);
    return partition;
}

}  // namespace rubble
