#include "core/fracture/cuts/CutPartition.h"

#include "core/base/QuantityText.h"
#include "core/base/RadixSort.h"
#include "core/fracture/cuts/CutOverlay.h"
#include "core/fracture/partition/EdgeIndex.h"
#include "core/fracture/partition/PieceRings.h"
#include "core/geometry/polygon/ContainmentIndex.h"
#include "core/geometry/polygon/IndexedCorners.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace rubble {
namespace {

/// A piece of the result. Pieces are ordered by the old order of their seeds, then their cells, then their smallest
/// corner.
struct NewPiece {
    std::uint32_t source = 0;    // the old piece that it is, or is a part of
    std::uint32_t face = kNone;  // kNone: it is the old piece, unchanged
    std::uint32_t part = kNone;  // index of a part of a face that touches itself; kNone: the whole face
    std::uint32_t cells = 0;     // offset of its cells in cut layers
    std::uint32_t seedOrder = 0;
};
constexpr std::uint32_t kUnchanged = 0x80000000u;  // flag of the number of an unchanged old piece

/// Builds the partition of the overlay's faces and the unchanged pieces.
class PartitionBuilder {
public:
    PartitionBuilder(Partition&& partition, CutOverlay&& overlay, const Polygon& outline, const CutSet& cuts,
                     const TaskContext& task)
        : m_old(std::move(partition)), m_overlay(std::move(overlay)), m_outline(outline), m_cuts(cuts), m_task(task) {}

    Result<Partition> run() && {
        reportLooseCuts();
        if (!collectPieces()) return TaskContext::cancelled();
        return assemble();
    }

private:
    void reportLooseCuts() {
        std::map<std::array<std::uint32_t, 2>, double> lengths;  // by layer and line
        if (m_overlay.faces.dangling.empty()) return;
        const ContainmentIndex outline(m_outline);
        for (const PlanarEdge& edge : m_overlay.faces.dangling) {
            if (edge.group == 0) continue;
            const Vec2 from = m_overlay.points[edge.from], to = m_overlay.points[edge.to];
            if (outline.of(m_old.origin + (from + to) / 2.0) != Containment::Inside) continue;
            lengths[{m_cuts.layers[edge.group - 1].id, edge.line}] += glm::distance(from, to);
        }
        for (const auto& [of, length] : lengths) {
            const std::string line = std::to_string(of[1]) + " of layer " + std::to_string(of[0]);
            m_old.diagnostics.push_back(diagnostic(DiagnosticCode::LooseCut, {.layer = of[0], .index = of[1]},
                                                   "Cut " + line + " separates nothing along " +
                                                       quantityText(QuantityKind::Length, length) +
                                                       "; this part is omitted.",
                                                   length));
        }
    }

    /// Collects the pieces of the result, in order. False if cancelled.
    bool collectPieces() {
        m_namingLayers = static_cast<std::uint32_t>(
            std::ranges::count_if(m_cuts.layers, [](const CutLayer& layer) { return bool(layer.cellAt); }));
        m_pieces.reserve(m_overlay.faces.count() + m_old.pieceCount());
        m_cells.reserve(m_pieces.capacity() * m_namingLayers);
        for (std::uint32_t piece = 0; piece < m_old.pieceCount(); ++piece) {
            if (piece % 4096 == 0 && m_task.isCancelled()) return false;
            if (!m_overlay.isCut[piece]) add({.source = piece});
        }
        std::vector<std::uint32_t> lastFaceAt(m_overlay.points.size(), 0);  // of each point
        for (std::uint32_t face = 1; face < m_overlay.faces.count(); ++face) {
            if (face % 4096 == 0 && m_task.isCancelled()) return false;
            if (m_overlay.isInCutPiece(face)) addFace(face, m_overlay.pieceOfFace[face], lastFaceAt);
        }
        sortPieces();
        return true;
    }

    void sortPieces() {
        // Radix sort by a key that holds as much of the order as fits; hardly any two keys are equal.
        constexpr int kKeyBits = 32;
        const auto count = static_cast<std::uint32_t>(m_pieces.size());
        UninitializedVector<KeyedIndex> entries(count), other(count);
        std::vector<std::uint32_t> keys(count, 0);
        int width = 0;
        const auto extendKeys = [&](auto valueOf) {
            std::uint32_t max = 0;
            for (const NewPiece& piece : m_pieces) max = std::max(max, valueOf(piece));
            const int bits = std::bit_width(max), kept = std::min(bits, kKeyBits - width);
            for (std::uint32_t k = 0; k < count && kept > 0; ++k)
                keys[k] =
                    static_cast<std::uint32_t>(std::uint64_t{keys[k]} << kept | valueOf(m_pieces[k]) >> (bits - kept));
            width += kept;
        };
        extendKeys([](const NewPiece& piece) { return piece.seedOrder; });
        for (std::uint32_t layer = 0; layer < m_namingLayers && width < kKeyBits; ++layer)
            extendKeys([&](const NewPiece& piece) { return m_cells[piece.cells + layer]; });
        for (std::uint32_t k = 0; k < count; ++k) entries[k] = keyedIndex(keys[k], k);
        const std::span<KeyedIndex> order = radixSortByKey(entries, other, width);
        const auto isEntryBefore = [this](KeyedIndex a, KeyedIndex b) {
            return isBefore(m_pieces[indexOf(a)], m_pieces[indexOf(b)]);
        };
        std::vector<NewPiece> sorted;
        sorted.reserve(count);
        for (auto first = order.begin(), end = first; first != order.end(); first = end) {
            while (end != order.end() && keyOf(*end) == keyOf(*first)) ++end;
            if (end - first > 1) std::sort(first, end, isEntryBefore);
            for (auto entry = first; entry != end; ++entry) sorted.push_back(m_pieces[indexOf(*entry)]);
        }
        m_pieces = std::move(sorted);
    }
    bool isBefore(const NewPiece& a, const NewPiece& b) const {
        if (a.seedOrder != b.seedOrder) return a.seedOrder < b.seedOrder;
        const auto cellsOf = [this](const NewPiece& piece) {
            return std::span(m_cells).subspan(piece.cells, m_namingLayers);
        };
        const std::span<const std::uint32_t> one = cellsOf(a), other = cellsOf(b);
        const auto cells = std::lexicographical_compare_three_way(one.begin(), one.end(), other.begin(), other.end());
        if (cells != 0) return cells < 0;
        const Vec2 corner = smallestCorner(a), otherCorner = smallestCorner(b);
        return corner != otherCorner ? lexicographicLess(corner, otherCorner) : a.face < b.face;
    }

    void addFace(std::uint32_t face, std::uint32_t piece, std::vector<std::uint32_t>& lastFaceAt) {
        bool touchesItself = false;
        m_overlay.faces.forEachHalfEdgeOf(face, [&](std::uint32_t h) {
            const std::uint32_t point = m_overlay.faces.origin(h);
            touchesItself = touchesItself || lastFaceAt[point] == face;
            lastFaceAt[point] = face;
        });
        if (!touchesItself) return add({.source = piece, .face = face});
        PieceRings rings;
        for (std::uint32_t ring = m_overlay.faces.ringsBegin[face]; ring < m_overlay.faces.ringsBegin[face + 1];
             ++ring) {
            PieceRing& corners = rings.emplace_back();
            m_overlay.faces.forEachHalfEdge(ring, [&](std::uint32_t h) {
                corners.push_back({m_overlay.faces.origin(h), behind(h)});
            });
        }
        for (PieceRings& part : connectedParts(std::move(rings), m_overlay.points)) {
            m_parts.push_back(std::move(part));
            add({.source = piece, .face = face, .part = static_cast<std::uint32_t>(m_parts.size()) - 1});
        }
    }

    /// What is behind a half-edge: a face, an unchanged old piece flagged by kUnchanged, or kNone.
    std::uint32_t behind(std::uint32_t halfEdge) const {
        const std::uint32_t face = m_overlay.faces.faceOf[halfEdge ^ 1];
        // An unchanged piece has no faces: only the edge names it.
        const bool isCut = m_overlay.faces.edges[halfEdge >> 1].group != 0;
        const std::uint32_t piece = isCut ? m_overlay.pieceOfFace[face] : m_overlay.faces.pieceOf(halfEdge ^ 1);
        if (piece >= CutOverlay::kUnknown) return kNone;
        return m_overlay.isCut[piece] ? face : piece | kUnchanged;
    }

    /// Calls visit(position) for each corner of a piece's outer ring.
    template <class Visit>
    void forEachOuterCorner(const NewPiece& piece, Visit visit) const {
        if (piece.part != kNone) {
            for (const PieceCorner& corner : m_parts[piece.part][0]) visit(m_overlay.points[corner.point]);
        } else if (piece.face != kNone) {
            m_overlay.faces.forEachHalfEdge(m_overlay.faces.ringsBegin[piece.face], [&](std::uint32_t h) {
                visit(m_overlay.points[m_overlay.faces.origin(h)]);
            });
        } else {
            for (const std::uint32_t point : m_old.ringCorners(m_old.outerRing(piece.source)))
                visit(m_overlay.points[point]);
        }
    }
    Vec2 smallestCorner(const NewPiece& piece) const {
        Vec2 smallest(HUGE_VAL);
        forEachOuterCorner(piece, [&](Vec2 corner) { smallest = std::min(smallest, corner, lexicographicLess); });
        return smallest;
    }

    void add(NewPiece piece) {
        const std::uint32_t seed = m_old.seedOfPiece[piece.source];
        if (seed != kNone) piece.seedOrder = m_old.pieceOfSeed[seed];
        piece.cells = static_cast<std::uint32_t>(m_cells.size());
        if (m_namingLayers > 0) addCells(piece);
        m_pieces.push_back(piece);
    }
    /// The cells of cut layers are convex, or the cuts make them so: the mean of the corners lies in the same cell as
    /// all of them.
    void addCells(const NewPiece& piece) {
        Vec2 sum{0.0, 0.0};
        std::uint32_t corners = 0;
        forEachOuterCorner(piece, [&](Vec2 corner) {
            sum += corner;
            ++corners;
        });
        const Vec2 mean = m_old.origin + sum / static_cast<double>(corners);
        for (const CutLayer& layer : m_cuts.layers) {
            if (layer.cellAt) m_cells.push_back(layer.cellAt(mean));
        }
    }

    Partition assemble() {
        Partition made;
        made.origin = m_old.origin;
        made.diagnostics = std::move(m_old.diagnostics);
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
        made.neighbours.reserve(6 * m_pieces.size());
        m_numberOfFace.assign(m_overlay.faces.count(), kNone);
        m_numberOfUnchanged.assign(m_old.pieceCount(), kNone);
        for (std::uint32_t k = 0; k < m_pieces.size(); ++k) {
            const NewPiece& piece = m_pieces[k];
            std::uint32_t& number =
                piece.face == kNone ? m_numberOfUnchanged[piece.source] : m_numberOfFace[piece.face];
            number = std::min(number, k);
        }
        for (std::uint32_t face = 0; face < m_overlay.faces.count(); ++face) {
            const std::uint32_t piece = m_overlay.pieceOfFace[face];
            if (piece < CutOverlay::kUnknown && !m_overlay.isCut[piece])
                m_numberOfFace[face] = m_numberOfUnchanged[piece];
        }
        for (const NewPiece& piece : m_pieces) append(piece, made);
        if (!m_parts.empty()) setNeighboursInParts(made);
        made.points = std::move(m_overlay.points);
        reportLostSeeds(made);
        return made;
    }

    void append(const NewPiece& piece, Partition& made) const {
        const std::uint32_t seed = m_old.seedOfPiece[piece.source];
        if (seed != kNone && made.pieceOfSeed[seed] == kNone) made.pieceOfSeed[seed] = made.pieceCount();
        made.seedOfPiece.push_back(seed);
        for (std::uint32_t k = 0; k < m_namingLayers; ++k) made.cutCells.push_back(m_cells[piece.cells + k]);
        if (piece.part != kNone) {
            appendPart(m_parts[piece.part], made);
        } else if (piece.face != kNone) {
            appendFace(piece.face, made);
        } else {
            appendUnchanged(piece.source, made);
        }
        made.ringsOfPiece.push_back(static_cast<std::uint32_t>(made.cornersOfRing.size()) - 1);
    }

    static void endRing(Partition& made) {
        made.cornersOfRing.push_back(static_cast<std::uint32_t>(made.corners.size()));
    }

    void appendPart(const PieceRings& rings, Partition& made) const {
        for (const PieceRing& ring : rings) {
            for (const PieceCorner& corner : ring) {
                made.corners.push_back(corner.point);
                made.neighbours.push_back(numberOf(corner.neighbour));
            }
            endRing(made);
        }
    }

    void appendFace(std::uint32_t face, Partition& made) const {
        const PlanarFaces& faces = m_overlay.faces;
        for (std::uint32_t ring = faces.ringsBegin[face]; ring < faces.ringsBegin[face + 1]; ++ring) {
            faces.forEachHalfEdge(ring, [&](std::uint32_t h) {
                made.corners.push_back(faces.origin(h));
                made.neighbours.push_back(numberBehind(h));
            });
            endRing(made);
        }
    }

    void appendUnchanged(std::uint32_t source, Partition& made) const {
        for (std::uint32_t ring = m_old.ringsOfPiece[source]; ring < m_old.ringsOfPiece[source + 1]; ++ring) {
            const std::uint32_t begin = m_old.cornersOfRing[ring], end = m_old.cornersOfRing[ring + 1];
            for (std::uint32_t corner = begin; corner < end; ++corner) {
                const std::uint32_t from = m_old.corners[corner];
                const std::uint32_t to = m_old.corners[corner + 1 < end ? corner + 1 : begin];
                made.corners.push_back(from);
                made.neighbours.push_back(numberBehind(from, to, m_old.neighbours[corner]));
            }
            endRing(made);
        }
    }

    /// The new number of what behind() returns.
    std::uint32_t numberOf(std::uint32_t neighbour) const {
        if (neighbour == kNone) return kNone;
        return (neighbour & kUnchanged) != 0 ? m_numberOfUnchanged[neighbour & ~kUnchanged] : m_numberOfFace[neighbour];
    }

    /// The new number of the piece behind a half-edge. Cuts have faces on both sides.
    std::uint32_t numberBehind(std::uint32_t halfEdge) const {
        const bool isCut = m_overlay.faces.edges[halfEdge >> 1].group != 0;
        return isCut ? m_numberOfFace[m_overlay.faces.faceOf[halfEdge ^ 1]] : numberOf(behind(halfEdge));
    }

    /// The new number of the piece behind an edge of an unchanged piece.
    std::uint32_t numberBehind(std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) const {
        if (neighbour == kNone) return kNone;
        return numberOf(m_overlay.isCut[neighbour] ? m_overlay.faceBehindEdge.at({from, to}) : neighbour | kUnchanged);
    }

    /// A face that touches itself may be several pieces: sets the neighbour to the one that has the edge.
    void setNeighboursInParts(Partition& made) const {
        std::map<std::uint32_t, std::vector<std::uint32_t>> parts;  // by the first, all pieces of a face
        for (std::uint32_t k = 0; k < m_pieces.size(); ++k) {
            if (m_pieces[k].part != kNone) parts[m_numberOfFace[m_pieces[k].face]].push_back(k);
        }
        EdgeIndex index;
        for (const auto& [first, pieces] : parts) {
            for (const std::uint32_t piece : pieces) index.add(made, {.group = first, .piece = piece});
        }
        index.sort();
        for (std::uint32_t ring = 0; ring + 1 < made.cornersOfRing.size(); ++ring) {
            const std::uint32_t begin = made.cornersOfRing[ring], end = made.cornersOfRing[ring + 1];
            for (std::uint32_t corner = begin; corner < end; ++corner) {
                const auto found = parts.find(made.neighbours[corner]);
                if (found == parts.end() || found->second.size() < 2) continue;
                const std::uint32_t to = made.corners[corner + 1 < end ? corner + 1 : begin];
                const std::uint32_t piece = index.find(found->first, {to, made.corners[corner]});
                if (piece != kNone) made.neighbours[corner] = piece;
            }
        }
    }

    void reportLostSeeds(Partition& made) const {
        for (std::uint32_t seed = 0; seed < made.pieceOfSeed.size(); ++seed) {
            if (made.pieceOfSeed[seed] != kNone || m_old.pieceOfSeed[seed] == kNone) continue;
            made.diagnostics.push_back(
                diagnostic(DiagnosticCode::SeedWithoutCell, {.seed = seed},
                           "The cuts leave seed " + std::to_string(seed) + " no cell that is wider than rounding."));
        }
    }

    Partition m_old;
    CutOverlay m_overlay;
    const Polygon& m_outline;
    const CutSet& m_cuts;
    const TaskContext& m_task;
    std::vector<NewPiece> m_pieces;
    std::vector<PieceRings> m_parts;            // of faces that touch themselves; neighbours as behind() returns them
    std::uint32_t m_namingLayers = 0;           // cut layers whose cells have names
    std::vector<std::uint32_t> m_cells;         // of each piece, one per naming layer
    std::vector<std::uint32_t> m_numberOfFace;  // new number of the face's first piece; kNone: outside
    std::vector<std::uint32_t> m_numberOfUnchanged;  // new number of each unchanged old piece
};

}  // namespace

Result<Partition> cutApart(Partition partition, const Polygon& outline, const CutSet& cuts, const TaskContext& task) {
    if (cuts.isEmpty()) return partition;
    Result<CutOverlay> overlay = overlayCuts(partition, outline, cuts, task);
    if (!overlay) return overlay.error();
    return PartitionBuilder(std::move(partition), std::move(*overlay), outline, cuts, task).run();
}

}  // namespace rubble
