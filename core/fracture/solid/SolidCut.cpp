#include "core/fracture/solid/SolidCut.h"

#include "core/fracture/solid/SolidPoints.h"
#include "core/fracture/solid/SolidShells.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

class PartitionWriter {
public:
    PartitionWriter(const SolidDiagram& diagram, const SolidFaces& faces, const SolidShells& shells,
                    const SolidPoints& points)
        : m_diagram(diagram),
          m_faces(faces),
          m_shells(shells),
          m_onLattice(points.onLattice),
          m_placed(points.placed) {}

    SolidPartition write(std::size_t seedCount, const SolidLattice& lattice) {
        numberFragments(seedCount);
        finish(lattice);
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

    /// Names the fragments of faces, drops faces within one fragment, lists those of each, and scales to metres.
    void finish(const SolidLattice& lattice) {
        for (std::uint32_t f = 0; f < m_faces.faces.size(); ++f) {
            SolidPartition::Face face = m_faces.faces[f];
            face.fragment = m_fragmentOfShell[m_shells.ofSide[2 * f]];
            if (face.behind != kNone) face.behind = m_fragmentOfShell[m_shells.ofSide[2 * f + 1]];
            if (face.fragment == face.behind || face.fragment == kNone) continue;
            m_result.addFace(face, m_faces.trianglesOf(f));
        }
        m_result.listFaces();
        m_result.origin = lattice.origin();
        m_result.points.resize(m_placed.size());
        for (std::size_t p = 0; p < m_placed.size(); ++p) m_result.points[p] = lattice.metres(m_placed[p]);
        for (std::uint32_t k = 0; k < m_result.fragmentCount(); ++k) m_result.volumes.push_back(volumeOf(k));
        m_result.duplicates = m_diagram.sites().duplicates;
    }

    double volumeOf(std::uint32_t fragment) const {
        const std::span<const SolidPartition::FaceSide> sides = m_result.facesOf(fragment);
        const auto point = [this](std::uint32_t index) { return m_result.points[index]; };
        const Vec3 origin = point(m_result.trianglesOf(sides[0].face)[0][0]);
        double six = 0.0;
        for (const SolidPartition::FaceSide& side : sides) {
            for (const auto& [a, b, c] : m_result.trianglesOf(side.face)) {
                const double part = glm::dot(point(a) - origin, glm::cross(point(b) - origin, point(c) - origin));
                six += side.isReversed ? -part : part;
            }
        }
        return six / 6.0;
    }

    const SolidDiagram& m_diagram;
    const SolidFaces& m_faces;
    const SolidShells& m_shells;
    std::span<const Vec3> m_onLattice, m_placed;  // points, in steps
    std::vector<std::uint32_t> m_fragmentOfShell;
    SolidPartition m_result;
};

}  // namespace

Result<SolidPartition> cutSolid(const TriangleMesh& mesh, std::span<const Vec3> seeds, const TaskContext& task) {
    Box3 box = boundsOf(mesh);
    for (const Vec3 seed : seeds) box.include(seed);
    const SolidLattice lattice(box);
    LatticeMesh snapped;
    std::vector<Vec3> corners;
    for (const Vec3 point : mesh.points) {
        snapped.corners.push_back(lattice.snapped(point));
        corners.push_back(lattice.steps(point));
    }
    snapped.triangles = mesh.triangles;
    findEdges(snapped);
    std::vector<Vec3> sites;
    for (const Vec3 seed : seeds) sites.push_back(lattice.snapped(seed));

    Result<Tetrahedralization> triangulation = tetrahedralized(sites, task.stage(0.0, 0.3));
    if (!triangulation) return triangulation.error();
    const SolidDiagram diagram(std::move(*triangulation));
    const Result<SurfacePieces> pieces = walkSurface(snapped, diagram, task.stage(0.3, 0.6));
    if (!pieces) return pieces.error();
    const Result<InnerFaces> facets = innerFaces(snapped, diagram, *pieces);
    if (!facets) return facets.error();
    if (task.isCancelled()) return TaskContext::cancelled();
    const SolidPoints points = solidPoints(snapped, corners, diagram, *pieces, *facets);
    const SolidFaces faces = solidFaces(snapped, diagram, *pieces, *facets, points.onLattice);
    const SolidShells shells = solidShells(faces, points.onLattice);
    return PartitionWriter(diagram, faces, shells, points).write(seeds.size(), lattice);
}

}  // namespace rubble
