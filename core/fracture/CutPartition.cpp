#include "core/fracture/CutPartition.h"

#include "core/base/KeySort.h"
#include "core/base/MessageText.h"
#include "core/fracture/EdgeGrid.h"
#include "core/fracture/PieceRings.h"
#include "core/fracture/PlaneFaces.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <map>

namespace rubble {
namespace {

bool isSmaller(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// Which of the outline's corners a point of a partition is; kNone: none.
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
        forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t, std::uint32_t across) {
            if (across != kNone) return;
            const std::array<double, 2> place{partition.points[from].x, partition.points[from].y};
            const auto found =
                std::ranges::lower_bound(corners, place, {}, [](const auto& corner) { return corner.first; });
            if (found != corners.end() && found->first == place) vertices[from] = found->second;
        });
    }
    return vertices;
}

/// Whether an edge may pass through a box: not where all of it lies beyond a side, or all of the box on one side of the edge.
bool mayMeet(const EdgeGrid::Edge& edge, const Box2& box) {
    const Vec2 low = glm::min(edge.from, edge.to), high = glm::max(edge.from, edge.to);
    if (high.x < box.min.x || low.x > box.max.x || high.y < box.min.y || low.y > box.max.y) return false;
    const Vec2 along = edge.to - edge.from, half = (box.max - box.min) / 2.0;
    const double reach = std::abs(along.x) * half.y + std::abs(along.y) * half.x;
    constexpr double kRoom = 1.0 + 1e-9;  // far more than rounding takes
    return std::abs(cross(along, box.min + half - edge.from)) <= kRoom * reach;
}

/// Which pieces a cut comes near.
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
        for (const std::uint32_t corner : partition.ringCorners(partition.ringsOfPiece[piece]))
            box.include(partition.points[corner]);
        box.min -= Vec2(4.0 * margin);
        box.max += Vec2(4.0 * margin);
        isNear[piece] = grid.isAnyNear(box, [&](std::uint32_t line) { return mayMeet(lines[line], box); });
    }
    return isNear;
}

/// A piece as it will be. Pieces come in the order of their seeds' places, then of their cells, then of their smallest corners.
struct NewPiece {
    std::uint32_t was = 0;       // the piece it is, or is a part of
    std::uint32_t face = kNone;  // kNone: it stays as it is
    std::uint32_t part = kNone;  // of the faces that meet themselves; kNone: all of the face
    std::uint32_t cells = 0;     // where its cells of cut layers begin
    std::uint32_t seedPlace = 0;
};
constexpr std::uint32_t kStays = 0x80000000u;  // beside the number of a piece that stays as it is

class Cutting {
public:
    Cutting(Partition&& partition, const Polygon& outline, const CutSet& cuts, const TaskContext& task)
        : m_old(std::move(partition)),
          m_outline(outline),
          m_cuts(cuts),
          m_task(task),
          m_frame(frameOf(outline)),
          m_tips(outline, m_frame),
          m_vertices(outlineVertices(m_old, outline)),
          m_isCut(piecesNear(m_old, cuts, m_frame.joinDistance)) {}

    Result<Partition> run() && {
        while (true) {
            if (const Status found = findFaces(); !found) return found.error();
            if (!findPiecesOfFaces()) return TaskContext::cancelled();
            if (!hasPartedOthers()) break;
        }
        reportLooseCuts();
        if (!collectPieces()) return TaskContext::cancelled();
        return assembled();
    }

private:
    /// The edges of pieces that are near cuts, and the cuts.
    PlaneDrawing drawing() const {
        PlaneDrawing drawing{.points = m_old.points,
                             .isNodedGroup = {m_old.pieceCount() == 1},
                             .outlineVertex = m_vertices,
                             .frame = m_frame};
        const auto isCut = [this](std::uint32_t piece) { return piece != kNone && m_isCut[piece]; };
        for (std::uint32_t piece = 0; piece < m_old.pieceCount(); ++piece) {
            forEachEdge(m_old, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t across) {
                // Once an edge: by the lower piece.
                if ((across < piece) || !(isCut(piece) || isCut(across))) return;
                drawing.edges.push_back({from, to, 0, kNone, piece, across});
            });
        }
        const auto first = static_cast<std::uint32_t>(drawing.points.size());
        for (const Vec2 point : m_cuts.points) drawing.points.push_back(point - m_old.origin);
        std::uint32_t edge = 0;
        for (const CutLayer& layer : m_cuts.layers) {
            const auto group = static_cast<std::uint32_t>(drawing.isNodedGroup.size());
            drawing.isNodedGroup.push_back(layer.isNoded);
            for (; edge < layer.edgesEnd; ++edge) {
                const CutEdge& cut = m_cuts.edges[edge];
                drawing.edges.push_back({first + cut.from, first + cut.to, group, cut.line});
            }
        }
        return drawing;
    }

    Status findFaces() {
        PlaneDrawing plane = drawing();
        while (true) {
            if (const Status parted = partAtMeetings(m_tips, m_task, plane); !parted) return parted;
            Result<std::optional<PlaneFaces>> faces = facesOf(plane, m_task);
            if (!faces) return faces.error();
            if (*faces) {
                m_faces = std::move(**faces);
                m_points = std::move(plane.points);
                return success();
            }
            // Some edges that were trusted meet after all.
            const auto isTrusted = std::ranges::find(plane.isNodedGroup, true);
            if (isTrusted == plane.isNodedGroup.end()) break;
            plane.isNodedGroup.assign(plane.isNodedGroup.size(), false);
        }
        return Error{ErrorCode::Degenerate, "The cuts of the pattern meet in too narrow a place to be told apart."};
    }

    /// Which piece each face is a part of: what the longest of its edges that bound pieces says; else, what is said beyond cuts.
    bool findPiecesOfFaces() {
        m_pieceOfFace.assign(m_faces.count(), kUnknown);
        m_pieceOfFace[0] = kNone;
        std::vector<std::uint32_t> known{0};
        std::vector<double> longest(m_faces.count(), -1.0);  // m^2
        for (std::uint32_t h = 0; h < m_faces.faceOf.size(); ++h) {
            const std::uint32_t face = m_faces.faceOf[h];
            if (face == 0 || m_faces.edges[h >> 1].group != 0) continue;
            const Vec2 edge = m_points[m_faces.origin(h ^ 1)] - m_points[m_faces.origin(h)];
            if (glm::dot(edge, edge) <= longest[face]) continue;
            if (longest[face] < 0.0) known.push_back(face);
            longest[face] = glm::dot(edge, edge);
            m_pieceOfFace[face] = m_faces.pieceOf(h);
        }
        for (std::size_t step = 0; !known.empty(); ++step) {
            if (step % 4096 == 0 && m_task.isCancelled()) return false;
            const std::uint32_t face = known.back();
            known.pop_back();
            forEachHalfEdge(face, [&](std::uint32_t h) {
                std::uint32_t& behind = m_pieceOfFace[m_faces.faceOf[h ^ 1]];
                if (m_faces.edges[h >> 1].group == 0 || behind != kUnknown) return;
                behind = m_pieceOfFace[face];
                known.push_back(m_faces.faceOf[h ^ 1]);
            });
        }
        return true;
    }
    template <class Visit>
    void forEachHalfEdge(std::uint32_t face, Visit visit) const {
        for (std::uint32_t ring = m_faces.ringsBegin[face]; ring < m_faces.ringsBegin[face + 1]; ++ring)
            m_faces.forEachHalfEdge(ring, visit);
    }

    /// Pieces that were to stay as they are get new points where cuts end at their edges: they are cut, too, then. False where there
    /// are none.
    bool hasPartedOthers() {
        m_behindStaying.clear();
        if (std::ranges::all_of(m_isCut, std::identity())) return false;
        for (std::uint32_t h = 0; h < m_faces.faceOf.size(); ++h) {
            const std::uint32_t piece = m_faces.edges[h >> 1].group == 0 ? m_faces.pieceOf(h) : kNone;
            if (piece == kNone || m_isCut[piece]) continue;
            m_behindStaying[{m_faces.origin(h), m_faces.origin(h ^ 1)}] = m_faces.faceOf[h ^ 1];
        }
        bool isAny = false;
        for (std::uint32_t piece = 0; piece < m_old.pieceCount(); ++piece) {
            if (m_isCut[piece]) continue;
            forEachEdge(m_old, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t across) {
                if (across == kNone || !m_isCut[across] || m_behindStaying.contains({from, to})) return;
                m_isCut[piece] = isAny = true;
            });
        }
        return isAny;
    }

    void reportLooseCuts() {
        std::map<std::array<std::uint32_t, 2>, double> lengths;  // by layer and line
        for (const PlaneEdge& edge : m_faces.loose) {
            if (edge.group == 0) continue;
            const Vec2 from = m_points[edge.from], to = m_points[edge.to];
            if (containment(m_outline, m_old.origin + (from + to) / 2.0) != Containment::Inside) continue;
            lengths[{m_cuts.layers[edge.group - 1].id, edge.line}] += glm::distance(from, to);
        }
        for (const auto& [of, length] : lengths) {
            const std::string line = std::to_string(of[1]) + " of layer " + std::to_string(of[0]);
            m_old.reports.push_back(
                {ReportCode::LooseCut, of[1], of[0], length,
                 "Cut " + line + " parts nothing along " + messageText(length) + " m, which are left out."});
        }
    }

    /// What becomes of all pieces, in their order.
    bool collectPieces() {
        m_namingLayers = static_cast<std::uint32_t>(
            std::ranges::count_if(m_cuts.layers, [](const CutLayer& layer) { return bool(layer.cellAt); }));
        m_pieces.reserve(m_faces.count() + m_old.pieceCount());
        m_cells.reserve(m_pieces.capacity() * m_namingLayers);
        for (std::uint32_t piece = 0; piece < m_old.pieceCount(); ++piece) {
            if (piece % 4096 == 0 && m_task.isCancelled()) return false;
            if (!m_isCut[piece]) add({.was = piece});
        }
        std::vector<std::uint32_t> lastSeen(m_points.size(), 0);  // the face at each point
        for (std::uint32_t face = 1; face < m_faces.count(); ++face) {
            if (face % 4096 == 0 && m_task.isCancelled()) return false;
            const std::uint32_t piece = m_pieceOfFace[face];
            if (piece < kUnknown && m_isCut[piece]) addFace(face, piece, lastSeen);
        }
        sortPieces();
        return true;
    }

    void sortPieces() {
        // First by a key that says as much of the order as goes into it: hardly any two are equal then.
        constexpr int kKeyBits = 32;
        const auto count = static_cast<std::uint32_t>(m_pieces.size());
        RawVector<Keyed> entries(count), other(count);
        std::vector<std::uint32_t> keys(count, 0);
        int width = 0;
        const auto extendKeys = [&](auto valueOf) {
            std::uint32_t most = 0;
            for (const NewPiece& piece : m_pieces) most = std::max(most, valueOf(piece));
            const int bits = std::bit_width(most), kept = std::min(bits, kKeyBits - width);
            for (std::uint32_t k = 0; k < count && kept > 0; ++k)
                keys[k] =
                    static_cast<std::uint32_t>(std::uint64_t{keys[k]} << kept | valueOf(m_pieces[k]) >> (bits - kept));
            width += kept;
        };
        extendKeys([](const NewPiece& piece) { return piece.seedPlace; });
        for (std::uint32_t layer = 0; layer < m_namingLayers && width < kKeyBits; ++layer)
            extendKeys([&](const NewPiece& piece) { return m_cells[piece.cells + layer]; });
        for (std::uint32_t k = 0; k < count; ++k) entries[k] = keyed(keys[k], k);
        const std::span<Keyed> order = sortByKey(entries, other, width);
        const auto isBefore = [this](Keyed a, Keyed b) { return isAhead(m_pieces[indexOf(a)], m_pieces[indexOf(b)]); };
        std::vector<NewPiece> sorted;
        sorted.reserve(count);
        for (auto first = order.begin(), end = first; first != order.end(); first = end) {
            while (end != order.end() && keyOf(*end) == keyOf(*first)) ++end;
            if (end - first > 1) std::sort(first, end, isBefore);
            for (auto entry = first; entry != end; ++entry) sorted.push_back(m_pieces[indexOf(*entry)]);
        }
        m_pieces = std::move(sorted);
    }
    bool isAhead(const NewPiece& a, const NewPiece& b) const {
        if (a.seedPlace != b.seedPlace) return a.seedPlace < b.seedPlace;
        const auto cellsOf = [this](const NewPiece& piece) {
            return std::span(m_cells).subspan(piece.cells, m_namingLayers);
        };
        const std::span<const std::uint32_t> one = cellsOf(a), other = cellsOf(b);
        const auto cells = std::lexicographical_compare_three_way(one.begin(), one.end(), other.begin(), other.end());
        if (cells != 0) return cells < 0;
        const Vec2 corner = smallestCorner(a), otherCorner = smallestCorner(b);
        return corner != otherCorner ? isSmaller(corner, otherCorner) : a.face < b.face;
    }

    void addFace(std::uint32_t face, std::uint32_t piece, std::vector<std::uint32_t>& lastSeen) {
        bool isMeetingItself = false;
        forEachHalfEdge(face, [&](std::uint32_t h) {
            const std::uint32_t point = m_faces.origin(h);
            isMeetingItself = isMeetingItself || lastSeen[point] == face;
            lastSeen[point] = face;
        });
        if (!isMeetingItself) return add({.was = piece, .face = face});
        PieceRings rings;
        for (std::uint32_t ring = m_faces.ringsBegin[face]; ring < m_faces.ringsBegin[face + 1]; ++ring) {
            PieceRing& corners = rings.emplace_back();
            m_faces.forEachHalfEdge(ring, [&](std::uint32_t h) { corners.push_back({m_faces.origin(h), behind(h)}); });
        }
        for (PieceRings& part : connectedParts(std::move(rings), m_points)) {
            m_parts.push_back(std::move(part));
            add({.was = piece, .face = face, .part = static_cast<std::uint32_t>(m_parts.size()) - 1});
        }
    }

    /// What lies behind a half-edge: a face, a piece that stays as it is beside kStays, or kNone.
    std::uint32_t behind(std::uint32_t halfEdge) const {
        const std::uint32_t face = m_faces.faceOf[halfEdge ^ 1];
        // What stays as it is has no faces: its edge alone knows it.
        const bool isCut = m_faces.edges[halfEdge >> 1].group != 0;
        const std::uint32_t piece = isCut ? m_pieceOfFace[face] : m_faces.pieceOf(halfEdge ^ 1);
        if (piece >= kUnknown) return kNone;
        return m_isCut[piece] ? face : piece | kStays;
    }

    /// Calls visit(place) for each corner of a piece's outer ring.
    template <class Visit>
    void forEachOuterCorner(const NewPiece& piece, Visit visit) const {
        if (piece.part != kNone) {
            for (const PieceCorner& corner : m_parts[piece.part][0]) visit(m_points[corner.point]);
        } else if (piece.face != kNone) {
            m_faces.forEachHalfEdge(m_faces.ringsBegin[piece.face],
                                    [&](std::uint32_t h) { visit(m_points[m_faces.origin(h)]); });
        } else {
            for (const std::uint32_t point : m_old.ringCorners(m_old.ringsOfPiece[piece.was])) visit(m_points[point]);
        }
    }
    Vec2 smallestCorner(const NewPiece& piece) const {
        Vec2 smallest(HUGE_VAL);
        forEachOuterCorner(piece, [&](Vec2 corner) { smallest = std::min(smallest, corner, isSmaller); });
        return smallest;
    }

    void add(NewPiece piece) {
        const std::uint32_t seed = m_old.seedOfPiece[piece.was];
        if (seed != kNone) piece.seedPlace = m_old.pieceOfSeed[seed];
        piece.cells = static_cast<std::uint32_t>(m_cells.size());
        if (m_namingLayers > 0) addCells(piece);
        m_pieces.push_back(piece);
    }
    /// Cells of cut layers are convex, or are made so by the cuts: the middle of corners lies in the same one as all of them.
    void addCells(const NewPiece& piece) {
        Vec2 sum{0.0, 0.0};
        std::uint32_t corners = 0;
        forEachOuterCorner(piece, [&](Vec2 corner) {
            sum += corner;
            ++corners;
        });
        const Vec2 middle = m_old.origin + sum / static_cast<double>(corners);
        for (const CutLayer& layer : m_cuts.layers) {
            if (layer.cellAt) m_cells.push_back(layer.cellAt(middle));
        }
    }

    Partition assembled() {
        Partition made;
        made.origin = m_old.origin;
        made.reports = std::move(m_old.reports);
        for (const CutLayer& layer : m_cuts.layers) {
            if (layer.cellAt) made.cutLayers.push_back(layer.id);
        }
        made.pieceOfSeed.assign(m_old.pieceOfSeed.size(), kNone);
        made.ringsOfPiece = {0};
        made.cornersOfRing = {0};
        made.seedOfPiece.reserve(m_pieces.size());
        made.cutCells.reserve(m_pieces.size() * m_namingLayers);
        made.ringsOfPiece.reserve(m_pieces.size() + 1);
        made.cornersOfRing.reserve(m_pieces.size() + 1);
        made.corners.reserve(6 * m_pieces.size());
        made.across.reserve(6 * m_pieces.size());
        m_pieceMade.assign(m_faces.count(), kNone);
        m_pieceStaying.assign(m_old.pieceCount(), kNone);
        for (std::uint32_t k = 0; k < m_pieces.size(); ++k) {
            const NewPiece& piece = m_pieces[k];
            std::uint32_t& number = piece.face == kNone ? m_pieceStaying[piece.was] : m_pieceMade[piece.face];
            number = std::min(number, k);
        }
        for (std::uint32_t face = 0; face < m_faces.count(); ++face) {
            const std::uint32_t piece = m_pieceOfFace[face];
            if (piece < kUnknown && !m_isCut[piece]) m_pieceMade[face] = m_pieceStaying[piece];
        }
        for (const NewPiece& piece : m_pieces) append(piece, made);
        if (!m_parts.empty()) namePartsOfFaces(made);
        made.points = std::move(m_points);
        reportLostSeeds(made);
        return made;
    }

    void append(const NewPiece& piece, Partition& made) const {
        const std::uint32_t seed = m_old.seedOfPiece[piece.was];
        if (seed != kNone && made.pieceOfSeed[seed] == kNone) made.pieceOfSeed[seed] = made.pieceCount();
        made.seedOfPiece.push_back(seed);
        for (std::uint32_t k = 0; k < m_namingLayers; ++k) made.cutCells.push_back(m_cells[piece.cells + k]);
        const auto addCorner = [&](std::uint32_t point, std::uint32_t across) {
            made.corners.push_back(point);
            made.across.push_back(numberOf(across));
        };
        const auto endRing = [&] { made.cornersOfRing.push_back(static_cast<std::uint32_t>(made.corners.size())); };
        if (piece.part != kNone) {
            for (const PieceRing& ring : m_parts[piece.part]) {
                for (const PieceCorner& corner : ring) addCorner(corner.point, corner.across);
                endRing();
            }
        } else if (piece.face != kNone) {
            for (std::uint32_t ring = m_faces.ringsBegin[piece.face]; ring < m_faces.ringsBegin[piece.face + 1];
                 ++ring) {
                m_faces.forEachHalfEdge(ring, [&](std::uint32_t h) {
                    made.corners.push_back(m_faces.origin(h));
                    made.across.push_back(numberBehind(h));
                });
                endRing();
            }
        } else {
            for (std::uint32_t ring = m_old.ringsOfPiece[piece.was]; ring < m_old.ringsOfPiece[piece.was + 1]; ++ring) {
                const std::uint32_t begin = m_old.cornersOfRing[ring], end = m_old.cornersOfRing[ring + 1];
                for (std::uint32_t corner = begin; corner < end; ++corner) {
                    const std::uint32_t from = m_old.corners[corner],
                                        to = m_old.corners[corner + 1 < end ? corner + 1 : begin];
                    const std::uint32_t across = m_old.across[corner];
                    const bool isCut = across != kNone && m_isCut[across];
                    addCorner(from, isCut ? m_behindStaying.at({from, to}) : across == kNone ? kNone : across | kStays);
                }
                endRing();
            }
        }
        made.ringsOfPiece.push_back(static_cast<std::uint32_t>(made.cornersOfRing.size()) - 1);
    }

    /// The new number of what behind() names.
    std::uint32_t numberOf(std::uint32_t across) const {
        if (across == kNone) return kNone;
        return (across & kStays) != 0 ? m_pieceStaying[across & ~kStays] : m_pieceMade[across];
    }

    /// The new number of what lies behind a half-edge: of a cut, on whose both sides there are faces, read off at once.
    std::uint32_t numberBehind(std::uint32_t halfEdge) const {
        const bool isCut = m_faces.edges[halfEdge >> 1].group != 0;
        return isCut ? m_pieceMade[m_faces.faceOf[halfEdge ^ 1]] : numberOf(behind(halfEdge));
    }

    /// A face that meets itself may be several pieces: names the one that has the edge.
    void namePartsOfFaces(Partition& made) const {
        std::map<std::uint32_t, std::vector<std::uint32_t>> parts;  // by the first, all pieces of a face
        for (std::uint32_t k = 0; k < m_pieces.size(); ++k) {
            if (m_pieces[k].part != kNone) parts[m_pieceMade[m_pieces[k].face]].push_back(k);
        }
        for (std::uint32_t ring = 0; ring + 1 < made.cornersOfRing.size(); ++ring) {
            const std::uint32_t begin = made.cornersOfRing[ring], end = made.cornersOfRing[ring + 1];
            for (std::uint32_t corner = begin; corner < end; ++corner) {
                const auto found = parts.find(made.across[corner]);
                if (found == parts.end() || found->second.size() < 2) continue;
                const std::uint32_t to = made.corners[corner + 1 < end ? corner + 1 : begin];
                for (const std::uint32_t piece : found->second) {
                    if (hasEdge(made, piece, to, made.corners[corner])) made.across[corner] = piece;
                }
            }
        }
    }

    void reportLostSeeds(Partition& made) const {
        for (std::uint32_t seed = 0; seed < made.pieceOfSeed.size(); ++seed) {
            if (made.pieceOfSeed[seed] != kNone || m_old.pieceOfSeed[seed] == kNone) continue;
            made.reports.push_back(
                {ReportCode::SeedWithoutCell, seed, kNone, 0.0,
                 "The cuts leave seed " + std::to_string(seed) + " no cell that is wider than rounding."});
        }
    }

    static constexpr std::uint32_t kUnknown = kNone - 1;

    Partition m_old;
    const Polygon& m_outline;
    const CutSet& m_cuts;
    const TaskContext& m_task;
    const PointFrame m_frame;
    const OutlineTips m_tips;
    const std::vector<std::uint32_t> m_vertices;  // of the old points: corners of the outline
    std::vector<bool> m_isCut;                    // of the old pieces
    PlaneFaces m_faces;
    RawVector<Vec2> m_points;
    std::vector<std::uint32_t> m_pieceOfFace;                               // an old piece; kNone: outside
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> m_behindStaying;  // by an edge's points, the face behind it
    std::vector<NewPiece> m_pieces;
    std::vector<PieceRings> m_parts;            // of faces that meet themselves; corners name what behind() gives
    std::uint32_t m_namingLayers = 0;           // cut layers whose cells have names
    std::vector<std::uint32_t> m_cells;         // of each piece, one a naming layer
    std::vector<std::uint32_t> m_pieceMade;     // of each face, its first piece's new number; kNone: outside
    std::vector<std::uint32_t> m_pieceStaying;  // of each old piece that stays, its new number
};

}  // namespace

Result<Partition> cutApart(Partition partition, const Polygon& outline, const CutSet& cuts, const TaskContext& task) {
    if (cuts.isEmpty()) return partition;
    return Cutting(std::move(partition), outline, cuts, task).run();
}

}  // namespace rubble
