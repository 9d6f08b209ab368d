#include "core/fracture/solid/SolidFaces.h"

#include "core/base/DisjointSets.h"
#include "core/base/Parallel.h"
#include "core/fracture/solid/FaceLoops.h"
#include "core/fracture/solid/LoopNesting.h"
#include "core/fracture/solid/SolidPoints.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

namespace rubble {
namespace {

struct FacetStep {
    std::uint32_t facet;
    PointStep step;
};

/// What faces are made of.
struct FaceInput {
    const LatticeMesh& mesh;
    const SolidDiagram& diagram;
    const SurfacePieces& pieces;
    const InnerFaces& facets;
    std::span<const Vec3> points;
    UninitializedVector<std::uint32_t> cellOfPiece;
    std::vector<FacetStep> movedEdges;  // by facet
    std::vector<std::uint32_t> welded;  // the point that stands for each
};

/// Makes the faces of some pieces and facets. What has no area is left out; edges are then divided in `splits`.
class FaceMaker {
public:
    FaceMaker(const FaceInput& in, EdgeSplits& splits) : m_in(in), m_splits(splits) {}

    SolidFaces result;
    bool isAgain = false;           // another round is needed
    bool isLast = false;            // loops without area stay
    std::vector<PointStep> joined;  // points that coincide

    void addPiece(std::uint32_t piece) {
        const std::uint32_t first = m_in.pieces.firstCorner[piece], end = m_in.pieces.firstCorner[piece + 1];
        m_steps.clear();
        for (std::uint32_t c = first; c < end; ++c) {
            appendSteps({m_in.pieces.points[c], m_in.pieces.points[c + 1 < end ? c + 1 : first]}, m_steps);
        }
        m_whole.clear();
        for (const PointStep& step : m_steps) m_whole.push_back(step.from);
        if (isSimple(m_whole)) return addLoop(piece, m_whole);
        for (const PointLoop& loop : simpleLoops(m_whole)) addLoop(piece, loop);
    }

    void addFacet(std::uint32_t facet) {
        m_steps.clear();
        for (const PointStep& edge : m_in.facets.edges.of(facet)) appendSteps(edge, m_steps);
        const auto moved = std::ranges::equal_range(m_in.movedEdges, facet, {}, &FacetStep::facet);
        for (const FacetStep& edge : moved) appendSteps(edge.step, m_steps);
        if (m_steps.empty()) return;
        const std::array<std::uint32_t, 2>& sites = m_in.diagram.facets()[facet];
        const PlaneView view(m_in.diagram.site(sites[1]).point - m_in.diagram.site(sites[0]).point);
        std::vector<PointLoop> loops = linkedLoops(m_steps, m_in.points, view);
        std::erase_if(loops, [this](const PointLoop& loop) { return isDivided(loop); });
        for (const std::vector<PointLoop>& face : nestedLoops(std::move(loops), m_in.points, view)) {
            addFace(face, view, {sites[0], sites[1], kNone});
        }
    }

private:
    /// Appends the way from a point to the next as edges between welded points.
    void appendSteps(PointStep edge, std::vector<PointStep>& steps) {
        const std::uint32_t from = m_in.welded[edge.from], to = m_in.welded[edge.to];
        if (from == to) return;
        if (m_splits.isEmpty()) return steps.push_back({from, to});
        m_path.assign(1, from);
        m_splits.appendPath(from, to, m_path);
        for (std::size_t k = 1; k < m_path.size(); ++k) steps.push_back({m_path[k - 1], m_path[k]});
    }

    /// Whether points that coincide are one: not if they are on parts of the surface that only touch each other there,
    /// away from a common corner or edge.
    bool areOne(std::uint32_t a, std::uint32_t b) const {
        const std::vector<std::uint32_t> first = supportOf(m_in.mesh, m_in.pieces, a);
        const std::vector<std::uint32_t> second = supportOf(m_in.mesh, m_in.pieces, b);
        if (first.empty() || second.empty()) return true;
        std::vector<Vec3> common;
        for (const std::uint32_t corner : first) {
            if (std::ranges::find(second, corner) != second.end()) common.push_back(m_in.mesh.corners[corner]);
        }
        if (common.empty() || common.size() == 3) return !common.empty();
        const Vec3 point = m_in.points[a], offset = point - common[0];
        if (common.size() == 1) return glm::length(offset) <= 4.0 * kSolidWeldDistance;
        const Vec3 along = common[1] - common[0];
        return glm::length(glm::cross(offset, along)) <= 4.0 * kSolidWeldDistance * glm::length(along);
    }

    /// Has points of a face that coincide joined before the next round.
    void joinCoinciding(std::span<const PointLoop> loops) {
        std::vector<std::uint32_t> sorted;
        for (const PointLoop& loop : loops) sorted.insert(sorted.end(), loop.begin(), loop.end());
        std::sort(sorted.begin(), sorted.end(), [this](std::uint32_t a, std::uint32_t b) {
            return m_in.points[a] != m_in.points[b] ? lexicographicLess(m_in.points[a], m_in.points[b]) : a < b;
        });
        for (std::size_t k = 1; k < sorted.size(); ++k) {
            for (std::size_t before = k; before-- > 0;) {
                if (m_in.points[sorted[k]].x - m_in.points[sorted[before]].x > kSolidWeldDistance) break;
                if (sorted[k] == sorted[before] || !coincide(m_in.points[sorted[k]], m_in.points[sorted[before]]))
                    continue;
                if (!areOne(sorted[k], sorted[before])) continue;
                joined.push_back({sorted[before], sorted[k]});
                isAgain = true;
            }
        }
    }

    /// Has edges of a face that pass through another of its corners divided there before the next round.
    void divideTouched(std::span<const PointLoop> loops, double tolerance) {
        std::vector<std::pair<double, std::uint32_t>> byX;
        for (const PointLoop& loop : loops) {
            for (const std::uint32_t point : loop) byX.emplace_back(m_in.points[point].x, point);
        }
        std::sort(byX.begin(), byX.end());
        for (const PointLoop& loop : loops) {
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const std::uint32_t a = loop[k], b = loop[k + 1 < loop.size() ? k + 1 : 0];
                const auto [left, right] = std::minmax({m_in.points[a].x, m_in.points[b].x});
                auto it = std::ranges::lower_bound(byX, std::pair(left - tolerance, 0u));
                for (; it != byX.end() && it->first <= right + tolerance; ++it) {
                    if (!isOnEdge(m_in.points[it->second], m_in.points[a], m_in.points[b], tolerance)) continue;
                    isAgain = m_splits.add(a, b, it->second, m_in.points) || isAgain;
                }
            }
        }
    }

    /// Takes a loop without area out of the way: in the next round, its points that coincide are one, and its edges are
    /// divided by its points. False if there is nothing to divide.
    bool isDivided(const PointLoop& loop) {
        if (isLast || !isThin(loop, m_in.points)) return false;
        const bool wasAgain = std::exchange(isAgain, false);
        joinCoinciding(std::span(&loop, 1));
        divideTouched(std::span(&loop, 1), 4.0 * kSolidWeldDistance);  // more than isThin() allows
        return std::exchange(isAgain, isAgain || wasAgain);
    }

    /// Whether a loop has no point twice.
    static bool isSimple(const PointLoop& loop) {
        if (loop.size() < 3) return false;
        for (std::size_t k = 1; k < loop.size(); ++k) {
            for (std::size_t before = 0; before < k; ++before) {
                if (loop[before] == loop[k]) return false;
            }
        }
        return true;
    }

    /// Adds the face of a simple loop around a piece or a part of it.
    void addLoop(std::uint32_t piece, const PointLoop& loop) {
        if (isDivided(loop)) return;
        const std::array<Vec3, 3> corners = m_in.mesh.cornersOf(m_in.pieces.triangle[piece]);
        const PlaneView view(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        addFace(std::span(&loop, 1), view, {m_in.cellOfPiece[piece], kNone, m_in.pieces.triangle[piece]});
    }

    void addFace(std::span<const PointLoop> loops, const PlaneView& view, const SolidPartition::Face& face) {
        if (loops.size() > 1 || !triangulateConvex(m_in.points, loops[0], view, result.triangles)) {
            joinCoinciding(loops);
            divideTouched(loops, kSolidWeldDistance);
            triangulateFace(m_in.points, loops, view, kSolidWeldDistance, result.triangles);
        }
        result.firstTriangle.push_back(static_cast<std::uint32_t>(result.triangles.size()));
        result.faces.push_back(face);
        for (const PointLoop& loop : loops) {
            result.corners.insert(result.corners.end(), loop.begin(), loop.end());
            result.firstCorner.push_back(static_cast<std::uint32_t>(result.corners.size()));
        }
        result.firstLoop.push_back(static_cast<std::uint32_t>(result.firstCorner.size()) - 1);
    }

    const FaceInput& m_in;
    EdgeSplits& m_splits;
    PointLoop m_path, m_whole;
    std::vector<PointStep> m_steps;
};

class FaceBuilder {
public:
    FaceBuilder(const LatticeMesh& mesh, const SolidDiagram& diagram, const SurfacePieces& pieces,
                const InnerFaces& facets, std::span<const Vec3> points, const TaskContext& task)
        : m_in{mesh, diagram, pieces, facets, points, pieces.cell, {}, weldedPoints(points, pieces, facets, task)},
          m_task(task) {}

    Result<SolidFaces> build() {
        moveTiedPieces();
        if (m_task.isCancelled()) return TaskContext::cancelled();
        std::optional<SolidFaces> atOnce = facesAtOnce();
        Result<SolidFaces> faces = atOnce ? Result<SolidFaces>(std::move(*atOnce)) : facesByRounds();
        if (faces) faces->welded = std::move(m_in.welded);
        return faces;
    }

private:
    /// Pieces of triangles that lie in the bisector of two cells are in the cell on the inner side, whatever the ranks
    /// say: else the other cell would have a part of no thickness. The facet between both ends there then.
    void moveTiedPieces() {
        for (std::uint32_t piece = 0; piece < m_in.pieces.pieceCount() && !m_task.isCancelled(); ++piece) {
            const std::uint32_t receiver = innerCell(piece);
            if (receiver == kNone) continue;
            const std::uint32_t cell = m_in.pieces.cell[piece], facet = m_in.diagram.facetOf(cell, receiver);
            const std::uint32_t first = m_in.pieces.firstCorner[piece], end = m_in.pieces.firstCorner[piece + 1];
            for (std::uint32_t c = first; c < end; ++c) {
                const std::uint32_t from = m_in.pieces.points[c], to = m_in.pieces.points[c + 1 < end ? c + 1 : first];
                m_in.movedEdges.push_back({facet, cell < receiver ? PointStep{from, to} : PointStep{to, from}});
            }
            m_in.cellOfPiece[piece] = receiver;
        }
        std::ranges::stable_sort(m_in.movedEdges, {}, &FacetStep::facet);
    }

    /// The cell behind the bisector that a piece lies in, if that is its inner side; else kNone.
    std::uint32_t innerCell(std::uint32_t piece) const {
        const std::uint32_t cell = m_in.pieces.cell[piece], other = m_in.pieces.tiedCell[piece];
        if (other == kNone) return kNone;
        const std::uint32_t facet = m_in.diagram.facetOf(cell, other);
        if (m_in.facets.edges.of(facet).empty()) return kNone;
        const std::array<Vec3, 3> corners = m_in.mesh.cornersOf(m_in.pieces.triangle[piece]);
        const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        return glm::dot(normal, m_in.diagram.site(other).point - m_in.diagram.site(cell).point) < 0.0 ? other : kNone;
    }

    static constexpr std::size_t kItemsPerCheck = 64;

    /// Adds the faces of some pieces; stops when goesOn() is false.
    template <class GoesOn>
    void addPieces(FaceMaker& maker, IndexRange pieces, const GoesOn& goesOn) const {
        for (std::size_t k = pieces.begin; k < pieces.end; ++k) {
            if (k % kItemsPerCheck == 0 && !goesOn()) return;
            maker.addPiece(static_cast<std::uint32_t>(k));
        }
    }
    template <class GoesOn>
    void addFacets(FaceMaker& maker, IndexRange facets, const GoesOn& goesOn) const {
        for (std::size_t k = facets.begin; k < facets.end; ++k) {
            if (k % kItemsPerCheck == 0 && !goesOn()) return;
            maker.addFacet(static_cast<std::uint32_t>(k));
        }
    }

    std::size_t pieceCount() const { return m_in.pieces.pieceCount(); }
    std::size_t facetCount() const { return m_in.diagram.facets().size(); }

    /// All faces, made by several threads; nothing if some of them have to be made again: that depends on their order.
    std::optional<SolidFaces> facesAtOnce() const {
        constexpr std::size_t kPieces = 1024, kFacets = 32;  // of a part, about
        const bool isShared = m_task.threads > 1;
        const std::size_t facetParts = isShared ? facetCount() / kFacets + 1 : 0;
        const std::size_t pieceParts = isShared ? pieceCount() / kPieces + 1 : 1;  // the only one has the facets, too
        std::vector<SolidFaces> made(pieceParts + facetParts);
        std::atomic<bool> isAgain{false};
        forEachIndex(made.size(), m_task.threads, [&](std::size_t index) {
            EdgeSplits splits;
            FaceMaker maker(m_in, splits);
            const auto goesOn = [&] {
                if (maker.isAgain) isAgain.store(true, std::memory_order_relaxed);
                return !isAgain.load(std::memory_order_relaxed) && !m_task.isCancelled();
            };
            const bool isOfFacets = index < facetParts;  // they take longest, so they come first
            const std::size_t part = isOfFacets ? index : index - facetParts;
            if (!isOfFacets) addPieces(maker, chunkRange(pieceCount(), part, pieceParts), goesOn);
            if (isOfFacets || !isShared)
                addFacets(maker, chunkRange(facetCount(), part, std::max<std::size_t>(facetParts, 1)), goesOn);
            static_cast<void>(goesOn());
            made[isOfFacets ? pieceParts + part : part] = std::move(maker.result);
        });
        if (isAgain || m_task.isCancelled()) return std::nullopt;
        return isShared ? joinedParts(made) : std::move(made[0]);
    }

    SolidFaces joinedParts(const std::vector<SolidFaces>& parts) const {
        struct Place {
            std::size_t face, triangle, loop, corner;
        };
        std::vector<Place> places(parts.size() + 1, Place{0, 0, 0, 0});
        for (std::size_t k = 0; k < parts.size(); ++k) {
            places[k + 1] = {places[k].face + parts[k].faces.size(), places[k].triangle + parts[k].triangles.size(),
                             places[k].loop + parts[k].firstCorner.size() - 1,
                             places[k].corner + parts[k].corners.size()};
        }
        SolidFaces all;
        all.faces.resize(places.back().face);
        all.firstTriangle.resize(places.back().face + 1);
        all.triangles.resize(places.back().triangle);
        all.firstLoop.resize(places.back().face + 1);
        all.firstCorner.resize(places.back().loop + 1);
        all.corners.resize(places.back().corner);
        const auto copy = [](const auto& from, auto& to, std::size_t at) {
            std::ranges::copy(from, to.begin() + static_cast<std::ptrdiff_t>(at));
        };
        const auto copyStarts = [](const auto& from, auto& to, std::size_t at, std::size_t first) {
            for (std::size_t k = 1; k < from.size(); ++k) to[at + k] = from[k] + static_cast<std::uint32_t>(first);
        };
        forEachIndex(parts.size(), m_task.threads, [&](std::size_t k) {
            const auto& [face, triangle, loop, corner] = places[k];
            copy(parts[k].faces, all.faces, face);
            copy(parts[k].triangles, all.triangles, triangle);
            copy(parts[k].corners, all.corners, corner);
            copyStarts(parts[k].firstTriangle, all.firstTriangle, face, triangle);
            copyStarts(parts[k].firstLoop, all.firstLoop, face, loop);
            copyStarts(parts[k].firstCorner, all.firstCorner, loop, corner);
        });
        return all;
    }

    /// Makes all faces, again as long as loops without area divide the edges of others. That ends soon on a surface
    /// that does not cross itself.
    Result<SolidFaces> facesByRounds() {
        constexpr int kMaxRounds = 32;
        EdgeSplits splits;
        for (int round = 1;; ++round) {
            FaceMaker maker(m_in, splits);
            maker.isLast = round == kMaxRounds;
            const auto goesOn = [this] { return !m_task.isCancelled(); };
            addPieces(maker, {0, pieceCount()}, goesOn);
            addFacets(maker, {0, facetCount()}, goesOn);
            if (m_task.isCancelled()) return TaskContext::cancelled();
            if (!maker.isAgain || maker.isLast) return std::move(maker.result);
            if (maker.joined.empty()) continue;
            joinPoints(maker.joined);
            splits.clear();  // they are found again
        }
    }

    void joinPoints(std::span<const PointStep> pairs) {
        DisjointSets sets(m_in.points.size());
        for (const PointStep& pair : pairs) sets.merge(pair.from, pair.to);
        for (std::uint32_t& point : m_in.welded) point = sets.rootOf(point);
    }

    FaceInput m_in;
    const TaskContext& m_task;
};

}  // namespace

Result<SolidFaces> solidFaces(const LatticeMesh& mesh, const SolidDiagram& diagram, const SurfacePieces& pieces,
                              const InnerFaces& facets, std::span<const Vec3> points, const TaskContext& task) {
    return FaceBuilder(mesh, diagram, pieces, facets, points, task).build();
}

}  // namespace rubble
