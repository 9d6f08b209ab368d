#include "core/fracture/solid/SolidFaces.h"

#include "core/base/DisjointSets.h"
#include "core/fracture/solid/FaceLoops.h"
#include "core/fracture/solid/SolidPoints.h"
#include "core/geometry/polygon/Polygon.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {
namespace {

class FaceBuilder {
public:
    FaceBuilder(const LatticeMesh& mesh, const SolidDiagram& diagram, const SurfacePieces& pieces,
                const InnerFaces& facets, std::span<const Vec3> points)
        : m_mesh(mesh),
          m_diagram(diagram),
          m_pieces(pieces),
          m_facets(facets),
          m_points(points),
          m_cellOfPiece(pieces.cell),
          m_welded(weldedPoints(points, pieces, facets)) {}

    SolidFaces build() {
        moveTiedPieces();
        makeFaces();
        return std::move(m_result);
    }

private:
    /// Pieces of triangles that lie in the bisector of two cells are in the cell on the inner side, whatever the ranks
    /// say: else the other cell would have a part of no thickness. The facet between both ends there then.
    void moveTiedPieces() {
        for (std::uint32_t piece = 0; piece < m_pieces.pieceCount(); ++piece) {
            const std::uint32_t receiver = innerCell(piece);
            if (receiver == kNone) continue;
            const std::uint32_t cell = m_pieces.cell[piece], facet = m_diagram.facetOf(cell, receiver);
            const std::uint32_t first = m_pieces.firstCorner[piece], end = m_pieces.firstCorner[piece + 1];
            for (std::uint32_t c = first; c < end; ++c) {
                const std::uint32_t from = m_pieces.points[c], to = m_pieces.points[c + 1 < end ? c + 1 : first];
                m_movedEdges.push_back({facet, cell < receiver ? PointStep{from, to} : PointStep{to, from}});
            }
            m_cellOfPiece[piece] = receiver;
        }
        std::stable_sort(m_movedEdges.begin(), m_movedEdges.end(),
                         [](const FacetStep& a, const FacetStep& b) { return a.facet < b.facet; });
    }

    /// The cell behind the bisector that a piece lies in, if that is its inner side; else kNone.
    std::uint32_t innerCell(std::uint32_t piece) const {
        const std::uint32_t cell = m_pieces.cell[piece], other = m_pieces.tiedCell[piece];
        if (other == kNone) return kNone;
        const std::uint32_t facet = m_diagram.facetOf(cell, other);
        if (m_facets.firstEdge[facet] == m_facets.firstEdge[facet + 1]) return kNone;
        const std::array<Vec3, 3> corners = m_mesh.cornersOf(m_pieces.triangle[piece]);
        const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        return glm::dot(normal, m_diagram.site(other).point - m_diagram.site(cell).point) < 0.0 ? other : kNone;
    }

    /// Appends the way from a point to the next as edges between welded points.
    void appendSteps(PointStep edge, std::vector<PointStep>& steps) {
        const std::uint32_t from = m_welded[edge.from], to = m_welded[edge.to];
        if (from == to) return;
        m_path.assign(1, from);
        m_splits.appendPath(from, to, m_path);
        for (std::size_t k = 1; k < m_path.size(); ++k) steps.push_back({m_path[k - 1], m_path[k]});
    }

    /// Makes all faces, again as long as loops without area divide the edges of others; in the last round, which hardly
    /// any mesh sees, they stay.
    void makeFaces() {
        constexpr int kMaxRounds = 32;
        for (int round = 1; round <= kMaxRounds; ++round) {
            m_result = {};
            m_isAgain = false;
            m_isLast = round == kMaxRounds;
            for (std::uint32_t piece = 0; piece < m_pieces.pieceCount(); ++piece) addPiece(piece);
            std::size_t moved = 0;
            for (std::uint32_t facet = 0; facet + 1 < m_facets.firstEdge.size(); ++facet) addFacet(facet, moved);
            if (!m_isAgain) return;
            joinPoints();
        }
    }

    /// Joins the points of m_joined. Splits are found again then.
    void joinPoints() {
        if (m_joined.empty()) return;
        DisjointSets sets(m_points.size());
        for (const PointStep& pair : m_joined) sets.merge(pair.from, pair.to);
        for (std::uint32_t& point : m_welded) point = sets.rootOf(point);
        m_joined.clear();
        m_splits.clear();
    }

    /// The corners of the mesh on whose edge or triangle a point of the surface is, or which it is; none of others.
    std::vector<std::uint32_t> supportOf(std::uint32_t point) const {
        const std::uint32_t corners = static_cast<std::uint32_t>(m_mesh.corners.size());
        if (point < corners) return {point};
        if (point < corners + m_pieces.edgeCrossings.size()) {
            const auto above = std::ranges::upper_bound(m_pieces.firstCrossing, point - corners);
            const auto& ends = m_mesh.edges[static_cast<std::size_t>(above - m_pieces.firstCrossing.begin()) - 1];
            return {ends[0], ends[1]};
        }
        const std::size_t crossing = point - corners - m_pieces.edgeCrossings.size();
        if (crossing >= m_pieces.triangleCrossings.size()) return {};
        const auto& triangle = m_mesh.triangles[m_pieces.triangleCrossings[crossing].triangle];
        return {triangle.begin(), triangle.end()};
    }

    /// Whether points that coincide are one: not if they are on parts of the surface that only touch each other.
    bool areOne(std::uint32_t a, std::uint32_t b) const {
        const std::vector<std::uint32_t> first = supportOf(a), second = supportOf(b);
        if (first.empty() || second.empty()) return true;
        return std::ranges::find_first_of(first, second) != first.end();
    }

    /// Has points of a face that coincide joined before the next round.
    void joinCoinciding(std::span<const PointLoop> loops) {
        std::vector<std::uint32_t> sorted;
        for (const PointLoop& loop : loops) sorted.insert(sorted.end(), loop.begin(), loop.end());
        std::sort(sorted.begin(), sorted.end(), [this](std::uint32_t a, std::uint32_t b) {
            return m_points[a] != m_points[b] ? lexicographicLess(m_points[a], m_points[b]) : a < b;
        });
        for (std::size_t k = 1; k < sorted.size(); ++k) {
            for (std::size_t before = k; before-- > 0;) {
                if (m_points[sorted[k]].x - m_points[sorted[before]].x > kSolidWeldDistance) break;
                if (sorted[k] == sorted[before] || !coincide(m_points[sorted[k]], m_points[sorted[before]])) continue;
                if (!areOne(sorted[k], sorted[before])) continue;
                m_joined.push_back({sorted[before], sorted[k]});
                m_isAgain = true;
            }
        }
    }

    /// Has edges of a face that pass through another of its corners divided there before the next round.
    /// `always`: also by points on parts of the surface that only touch each other.
    void divideTouched(std::span<const PointLoop> loops, bool always) {
        const double tolerance = (always ? 4.0 : 1.0) * kSolidWeldDistance;  // more than isThin() allows
        std::vector<std::pair<double, std::uint32_t>> byX;
        for (const PointLoop& loop : loops) {
            for (const std::uint32_t point : loop) byX.emplace_back(m_points[point].x, point);
        }
        std::sort(byX.begin(), byX.end());
        for (const PointLoop& loop : loops) {
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const std::uint32_t a = loop[k], b = loop[k + 1 < loop.size() ? k + 1 : 0];
                const auto [left, right] = std::minmax({m_points[a].x, m_points[b].x});
                auto it = std::ranges::lower_bound(byX, std::pair(left - tolerance, 0u));
                for (; it != byX.end() && it->first <= right + tolerance; ++it) {
                    if (!isOnEdge(m_points[it->second], m_points[a], m_points[b], tolerance)) continue;
                    if (!always && !areOne(it->second, a) && !areOne(it->second, b)) continue;
                    m_isAgain = m_splits.add(a, b, it->second, m_points) || m_isAgain;
                }
            }
        }
    }

    /// Takes a loop without area out of the way: in the next round, its points that coincide are one, and its edges are
    /// divided by its points. False if there is nothing to divide.
    bool isDivided(const PointLoop& loop) {
        if (m_isLast || !isThin(loop, m_points)) return false;
        const bool wasAgain = std::exchange(m_isAgain, false);
        joinCoinciding(std::span(&loop, 1));
        divideTouched(std::span(&loop, 1), true);
        return std::exchange(m_isAgain, m_isAgain || wasAgain);
    }

    void addFace(std::vector<PointLoop> loops, const PlaneView& view, const SolidPartition::Face& face) {
        if (loops.size() > 1 || !triangulateConvex(m_points, loops[0], view, m_result.triangles)) {
            joinCoinciding(loops);
            divideTouched(loops, false);
            triangulateFace(m_points, loops, view, m_result.triangles);
        }
        m_result.firstTriangle.push_back(static_cast<std::uint32_t>(m_result.triangles.size()));
        m_result.faces.push_back(face);
        for (PointLoop& loop : loops) m_result.loops.push_back(std::move(loop));
        m_result.firstLoop.push_back(static_cast<std::uint32_t>(m_result.loops.size()));
    }

    void addPiece(std::uint32_t piece) {
        const std::uint32_t first = m_pieces.firstCorner[piece], end = m_pieces.firstCorner[piece + 1];
        m_steps.clear();
        for (std::uint32_t c = first; c < end; ++c) {
            appendSteps({m_pieces.points[c], m_pieces.points[c + 1 < end ? c + 1 : first]}, m_steps);
        }
        PointLoop whole;
        for (const PointStep& step : m_steps) whole.push_back(step.from);
        for (PointLoop& loop : simpleLoops(whole)) {
            if (isDivided(loop)) continue;
            const std::array<Vec3, 3> corners = m_mesh.cornersOf(m_pieces.triangle[piece]);
            const PlaneView view(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
            addFace({std::move(loop)}, view, {m_cellOfPiece[piece], kNone, m_pieces.triangle[piece]});
        }
    }

    /// Adds the faces of a facet; `moved`: its place in m_movedEdges.
    void addFacet(std::uint32_t facet, std::size_t& moved) {
        m_steps.clear();
        for (std::uint32_t e = m_facets.firstEdge[facet]; e < m_facets.firstEdge[facet + 1]; ++e) {
            appendSteps(m_facets.edges[e], m_steps);
        }
        for (; moved < m_movedEdges.size() && m_movedEdges[moved].facet == facet; ++moved) {
            appendSteps(m_movedEdges[moved].step, m_steps);
        }
        if (m_steps.empty()) return;
        const std::array<std::uint32_t, 2>& sites = m_diagram.facets()[facet];
        const PlaneView view(m_diagram.site(sites[1]).point - m_diagram.site(sites[0]).point);
        std::vector<PointLoop> loops = linkedLoops(m_steps, m_points, view);
        std::erase_if(loops, [this](const PointLoop& loop) { return isDivided(loop); });
        for (std::vector<PointLoop>& face : nestedLoops(std::move(loops), view)) {
            addFace(std::move(face), view, {sites[0], sites[1], kNone});
        }
    }

    /// Groups loops in a plane: each outer one with the holes in it.
    std::vector<std::vector<PointLoop>> nestedLoops(std::vector<PointLoop> loops, const PlaneView& view) const {
        std::vector<std::vector<PointLoop>> faces;
        if (loops.size() == 1) {
            faces.push_back(std::move(loops));
            return faces;
        }
        std::vector<Polygon> rings;
        std::vector<PointLoop> holes;
        for (PointLoop& loop : loops) {
            Ring ring;
            for (const std::uint32_t point : loop) ring.push_back(view(m_points[point]));
            if (signedArea(ring) > 0.0) {
                rings.push_back({std::move(ring), {}});
                faces.push_back({std::move(loop)});
            } else {
                holes.push_back(std::move(loop));
            }
        }
        const std::size_t outerCount = faces.size();
        for (PointLoop& hole : holes) {
            Ring ring;
            for (const std::uint32_t point : hole) ring.push_back(view(m_points[point]));
            const std::size_t around = ringAround(rings, ring);
            if (around < outerCount)
                faces[around].push_back(std::move(hole));
            else
                faces.push_back({std::move(hole)});  // of hardly any area
        }
        return faces;
    }

    /// The smallest polygon around a hole; the number of polygons if there is none.
    static std::size_t ringAround(const std::vector<Polygon>& polygons, const Ring& hole) {
        const Vec2 inside = pointIn(hole);  // not a corner, which may lie on an edge
        std::size_t around = polygons.size();
        for (std::size_t k = 0; k < polygons.size(); ++k) {
            const double area = signedArea(polygons[k].outer);
            // What fills a hole exactly, as another part of the mesh may, is in it, not around it.
            if (area < -(1.0 + 1e-9) * signedArea(hole)) continue;
            if (containment(polygons[k], inside) == Containment::Outside) continue;
            if (around == polygons.size() || area < signedArea(polygons[around].outer)) around = k;
        }
        return around;
    }

    /// A point inside a simple ring: beside its lowest corner.
    static Vec2 pointIn(const Ring& ring) {
        const std::size_t count = ring.size();
        const std::size_t lowest =
            static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), lexicographicLess) - ring.begin());
        const Vec2 before = ring[(lowest + count - 1) % count], corner = ring[lowest],
                   after = ring[(lowest + 1) % count];
        const Polygon triangle = withCanonicalWinding({{before, corner, after}, {}});
        Vec2 deepest = (before + after) / 2.0;
        double depth = 0.0;
        for (const Vec2 other : ring) {
            if (other == before || other == corner || other == after) continue;
            if (containment(triangle, other) == Containment::Outside) continue;
            const double distance = std::abs(cross(after - before, other - before));
            if (distance > depth) depth = distance, deepest = other;
        }
        return (corner + deepest) / 2.0;
    }

    struct FacetStep {
        std::uint32_t facet;
        PointStep step;
    };

    const LatticeMesh& m_mesh;
    const SolidDiagram& m_diagram;
    const SurfacePieces& m_pieces;
    const InnerFaces& m_facets;
    std::span<const Vec3> m_points;
    std::vector<std::uint32_t> m_cellOfPiece;
    std::vector<FacetStep> m_movedEdges;  // by facet
    std::vector<std::uint32_t> m_welded;
    EdgeSplits m_splits;
    bool m_isAgain = false;           // another round of makeFaces() is needed
    bool m_isLast = false;            // this is the last round
    std::vector<PointStep> m_joined;  // points that coincide
    PointLoop m_path;
    std::vector<PointStep> m_steps;
    SolidFaces m_result;
};

}  // namespace

SolidFaces solidFaces(const LatticeMesh& mesh, const SolidDiagram& diagram, const SurfacePieces& pieces,
                      const InnerFaces& facets, std::span<const Vec3> points) {
    return FaceBuilder(mesh, diagram, pieces, facets, points).build();
}

}  // namespace rubble
