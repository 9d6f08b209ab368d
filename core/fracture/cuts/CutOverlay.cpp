#include "core/fracture/cuts/CutOverlay.h"

#include "core/fracture/cuts/EdgeGrid.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace rubble {
namespace {

/// The outline's vertex at each point of a partition; kNone: none.
std::vector<std::uint32_t> outlineVertices(const Partition& partition, const Polygon& outline) {
    std::vector<std::pair<std::array<double, 2>, std::uint32_t>> corners;
    const auto add = [&](const Ring& ring) {
        for (const Vec2 corner : ring) {
            const Vec2 point = corner - partition.origin;
            corners.push_back({{point.x, point.y}, static_cast<std::uint32_t>(corners.size())});
        }
    };
    add(outline.outer);
    for (const Ring& hole : outline.holes) add(hole);
    std::ranges::sort(corners);
    std::vector<std::uint32_t> vertices(partition.points.size(), kNone);
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t, std::uint32_t neighbour) {
            if (neighbour != kNone) return;
            const std::array<double, 2> position{partition.points[from].x, partition.points[from].y};
            const auto found =
                std::ranges::lower_bound(corners, position, {}, [](const auto& corner) { return corner.first; });
            if (found != corners.end() && found->first == position) vertices[from] = found->second;
        });
    }
    return vertices;
}

/// Whether an edge may intersect a box: false if it lies beyond one side, or the box lies on one side of its line.
bool mayMeet(const EdgeGrid::Edge& edge, const Box2& box) {
    const Vec2 low = glm::min(edge.from, edge.to), high = glm::max(edge.from, edge.to);
    if (high.x < box.min.x || low.x > box.max.x || high.y < box.min.y || low.y > box.max.y) return false;
    const Vec2 along = edge.to - edge.from, half = (box.max - box.min) / 2.0;
    const double extent = std::abs(along.x) * half.y + std::abs(along.y) * half.x;
    constexpr double kSlack = 1.0 + 1e-9;  // far above rounding
    return std::abs(cross(along, box.min + half - edge.from)) <= kSlack * extent;
}

/// Whether each piece is near a cut.
std::vector<bool> piecesNear(const Partition& partition, const CutSet& cuts, double margin) {
    std::vector<EdgeGrid::Edge> lines;
    lines.reserve(cuts.edges.size());
    for (const CutEdge& edge : cuts.edges) {
        lines.push_back({cuts.points[edge.from] - partition.origin, cuts.points[edge.to] - partition.origin});
    }
    std::vector<bool> isNear(partition.pieceCount(), true);
    if (partition.pieceCount() == 1) return isNear;
    const EdgeGrid grid(lines, 4.0 * margin);
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        Box2 box;
        for (const std::uint32_t corner : partition.ringCorners(partition.outerRing(piece)))
            box.include(partition.points[corner]);
        box.min -= Vec2(4.0 * margin);
        box.max += Vec2(4.0 * margin);
        isNear[piece] = grid.isAnyNear(box, [&](std::uint32_t line) { return mayMeet(lines[line], box); });
    }
    return isNear;
}

class OverlayBuilder {
public:
    OverlayBuilder(const Partition& partition, const Polygon& outline, const CutSet& cuts, const TaskContext& task)
        : m_partition(partition),
          m_cuts(cuts),
          m_task(task),
          m_frame(localFrame(outline)),
          m_acuteCorners(outline, m_frame),
          m_vertices(outlineVertices(partition, outline)) {
        m_overlay.isCut = piecesNear(partition, cuts, m_frame.weldDistance);
    }

    Result<CutOverlay> run() && {
        do {
            if (const Status found = findFaces(); !found) return found.error();
            if (!findPiecesOfFaces()) return TaskContext::cancelled();
        } while (markFurtherPieces());
        return std::move(m_overlay);
    }

private:
    /// The edges of pieces that are near cuts, and the cuts.
    PlanarGraph makeGraph() const {
        PlanarGraph graph{.points = m_partition.points,
                          .isNodedGroup = {m_partition.pieceCount() == 1},
                          .outlineVertex = m_vertices,
                          .frame = m_frame};
        const auto isCut = [this](std::uint32_t piece) { return piece != kNone && m_overlay.isCut[piece]; };
        for (std::uint32_t piece = 0; piece < m_partition.pieceCount(); ++piece) {
            forEachEdge(m_partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
                // Each edge once: by the lower piece.
                if ((neighbour < piece) || !(isCut(piece) || isCut(neighbour))) return;
                graph.edges.push_back({from, to, 0, kNone, piece, neighbour});
            });
        }
        const auto first = static_cast<std::uint32_t>(graph.points.size());
        for (const Vec2 point : m_cuts.points) graph.points.push_back(point - m_partition.origin);
        std::uint32_t edge = 0;
        for (const CutLayer& layer : m_cuts.layers) {
            const auto group = static_cast<std::uint32_t>(graph.isNodedGroup.size());
            graph.isNodedGroup.push_back(layer.isNoded);
            for (; edge < layer.edgesEnd; ++edge) {
                const CutEdge& cut = m_cuts.edges[edge];
                graph.edges.push_back({first + cut.from, first + cut.to, group, cut.line});
            }
        }
        return graph;
    }

    Status findFaces() {
        PlanarGraph graph = makeGraph();
        while (true) {
            if (const Status split = splitAtIntersections(m_acuteCorners, m_task, graph); !split) return split;
            Result<std::optional<PlanarFaces>> faces = facesOf(graph, m_task);
            if (!faces) return faces.error();
            if (*faces) {
                m_overlay.faces = std::move(**faces);
                m_overlay.points = std::move(graph.points);
                return success();
            }
            // Some edges of a group that is noded meet elsewhere after all.
            const auto noded = std::ranges::find(graph.isNodedGroup, true);
            if (noded == graph.isNodedGroup.end()) break;
            graph.isNodedGroup.assign(graph.isNodedGroup.size(), false);
        }
        return Error{ErrorCode::Degenerate, "Cuts of the pattern are too close together to be distinguished."};
    }

    /// Finds the piece that each face is a part of: the one at its longest edge that bounds a piece; else that of a
    /// face beyond a cut.
    bool findPiecesOfFaces() {
        m_overlay.pieceOfFace.assign(m_overlay.faces.count(), CutOverlay::kUnknown);
        m_overlay.pieceOfFace[0] = kNone;
        std::vector<std::uint32_t> known{0};
        std::vector<double> longest(m_overlay.faces.count(), -1.0);  // m²
        for (std::uint32_t h = 0; h < m_overlay.faces.faceOf.size(); ++h) {
            const std::uint32_t face = m_overlay.faces.faceOf[h];
            if (face == 0 || m_overlay.faces.edges[h >> 1].group != 0) continue;
            const Vec2 edge =
                m_overlay.points[m_overlay.faces.origin(h ^ 1)] - m_overlay.points[m_overlay.faces.origin(h)];
            if (glm::dot(edge, edge) <= longest[face]) continue;
            if (longest[face] < 0.0) known.push_back(face);
            longest[face] = glm::dot(edge, edge);
            m_overlay.pieceOfFace[face] = m_overlay.faces.pieceOf(h);
        }
        for (std::size_t step = 0; !known.empty(); ++step) {
            if (step % 4096 == 0 && m_task.isCancelled()) return false;
            const std::uint32_t face = known.back();
            known.pop_back();
            m_overlay.faces.forEachHalfEdgeOf(face, [&](std::uint32_t h) {
                std::uint32_t& behind = m_overlay.pieceOfFace[m_overlay.faces.faceOf[h ^ 1]];
                if (m_overlay.faces.edges[h >> 1].group == 0 || behind != CutOverlay::kUnknown) return;
                behind = m_overlay.pieceOfFace[face];
                known.push_back(m_overlay.faces.faceOf[h ^ 1]);
            });
        }
        return true;
    }
    /// Marks unchanged pieces that get new points, where cuts end at their edges, as cut. False if there are none.
    bool markFurtherPieces() {
        m_overlay.faceBehindEdge.clear();
        if (std::ranges::all_of(m_overlay.isCut, std::identity())) return false;
        for (std::uint32_t h = 0; h < m_overlay.faces.faceOf.size(); ++h) {
            const std::uint32_t piece = m_overlay.faces.edges[h >> 1].group == 0 ? m_overlay.faces.pieceOf(h) : kNone;
            if (piece == kNone || m_overlay.isCut[piece]) continue;
            m_overlay.faceBehindEdge[{m_overlay.faces.origin(h), m_overlay.faces.origin(h ^ 1)}] =
                m_overlay.faces.faceOf[h ^ 1];
        }
        bool isAny = false;
        for (std::uint32_t piece = 0; piece < m_partition.pieceCount(); ++piece) {
            if (m_overlay.isCut[piece]) continue;
            forEachEdge(m_partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
                if (neighbour == kNone || !m_overlay.isCut[neighbour] || m_overlay.faceBehindEdge.contains({from, to}))
                    return;
                m_overlay.isCut[piece] = isAny = true;
            });
        }
        return isAny;
    }

    const Partition& m_partition;
    const CutSet& m_cuts;
    const TaskContext& m_task;
    const LocalFrame m_frame;
    const AcuteCorners m_acuteCorners;
    const std::vector<std::uint32_t> m_vertices;  // of the partition's points, see outlineVertices()
    CutOverlay m_overlay;
};

}  // namespace

Result<CutOverlay> overlayCuts(const Partition& partition, const Polygon& outline, const CutSet& cuts,
                               const TaskContext& task) {
    return OverlayBuilder(partition, outline, cuts, task).run();
}

}  // namespace rubble
