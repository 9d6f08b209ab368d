#include "core/fracture/voronoi/VoronoiPartition.h"

#include "core/base/Parallel.h"
#include "core/fracture/partition/CappedDiagnostics.h"
#include "core/fracture/partition/EdgeIndex.h"
#include "core/fracture/voronoi/CellAssembly.h"

#include <algorithm>
#include <string>

namespace rubble {
namespace {

constexpr std::uint32_t kSitesPerRange = 4096;

/// The outline as the only piece.
Partition wholeOutline(const Polygon& outline, std::uint32_t seed) {
    Partition partition;
    partition.origin = localFrame(outline).origin;
    partition.seedOfPiece = {seed};
    partition.cornersOfRing = {0};
    const auto addRing = [&](const Ring& ring) {
        for (const Vec2 point : ring) {
            partition.corners.push_back(static_cast<std::uint32_t>(partition.points.size()));
            partition.neighbours.push_back(kNone);
            partition.points.push_back(point - partition.origin);
        }
        partition.cornersOfRing.push_back(static_cast<std::uint32_t>(partition.corners.size()));
    };
    addRing(outline.outer);
    for (const Ring& hole : outline.holes) addRing(hole);
    partition.ringsOfPiece = {0, static_cast<std::uint32_t>(outline.holes.size()) + 1};
    return partition;
}

/// Concatenates ranges of cells to a partition, and replaces neighbouring sites by pieces.
class RangeConcatenation {
public:
    RangeConcatenation(const Delaunay& delaunay, std::span<const CellRange> ranges, Partition& partition)
        : m_delaunay(delaunay), m_ranges(ranges), m_partition(partition) {
        for (const CellRange& range : ranges) {
            m_begins.push_back(m_end);
            m_end.corners += range.pieces.corners.size();
            m_end.rings += range.pieces.ringEnds.size();
            m_end.pieces += range.pieces.pieceEnds.size();
        }
        partition.corners.resize(m_end.corners);
        partition.neighbours.resize(m_end.corners);
        partition.cornersOfRing.resize(m_end.rings + 1);
        partition.ringsOfPiece.resize(m_end.pieces + 1);
        partition.seedOfPiece.resize(m_end.pieces);
        partition.cornersOfRing[0] = partition.ringsOfPiece[0] = 0;
        m_firstPieces.resize(delaunay.sites.size() + 1);
        m_firstPieces.back() = static_cast<std::uint32_t>(m_end.pieces);
    }

    void run(int threads) {
        forEachIndex(m_ranges.size(), threads, [this](std::size_t k) { copy(k); });
        if (isEachSiteOnePiece()) return;
        for (std::uint32_t site = 0; site + 1 < m_firstPieces.size(); ++site) {
            if (!isIndexed(site)) continue;
            for (std::uint32_t piece = m_firstPieces[site]; piece < m_firstPieces[site + 1]; ++piece)
                m_edges.add(m_partition, {.group = site, .piece = piece});
        }
        m_edges.sort();
        forEachIndex(m_ranges.size(), threads, [this](std::size_t k) { replaceSitesByPieces(k); });
    }

    Coincidences coincidences(const PointNumbers& numbers, double distance) const {
        Coincidences all = {{}, {}, numbers.vertices, numbers.crossings, distance};
        for (std::size_t k = 0; k < m_ranges.size(); ++k) {
            const CellRange& range = m_ranges[k];
            all.pairs.insert(all.pairs.end(), range.coincident.begin(), range.coincident.end());
            const std::uint32_t begin = static_cast<std::uint32_t>(m_begins[k].pieces);
            for (const TouchingVertex& touch : range.touches) {
                all.touches.push_back({touch.point, begin + touch.firstPiece, begin + touch.lastPiece});
            }
        }
        return all;
    }

private:
    struct Offsets {
        std::size_t corners = 0, rings = 0, pieces = 0;
    };

    void copy(std::size_t k) {
        const CellRange& range = m_ranges[k];
        const Offsets begin = m_begins[k];
        for (std::size_t i = 0; i < range.pieces.corners.size(); ++i) {
            m_partition.corners[begin.corners + i] = range.pieces.corners[i].point;
            m_partition.neighbours[begin.corners + i] = range.pieces.corners[i].neighbour;
        }
        for (std::size_t i = 0; i < range.pieces.ringEnds.size(); ++i) {
            m_partition.cornersOfRing[begin.rings + i + 1] =
                static_cast<std::uint32_t>(begin.corners + range.pieces.ringEnds[i]);
        }
        for (std::size_t i = 0; i < range.pieces.pieceEnds.size(); ++i) {
            m_partition.ringsOfPiece[begin.pieces + i + 1] =
                static_cast<std::uint32_t>(begin.rings + range.pieces.pieceEnds[i]);
        }
        for (std::size_t i = 0; i + 1 < range.firstPieces.size(); ++i) {
            const std::size_t site = range.firstSite + i;
            const std::size_t first = begin.pieces + range.firstPieces[i];
            m_firstPieces[site] = static_cast<std::uint32_t>(first);
            for (std::size_t piece = first; piece < begin.pieces + range.firstPieces[i + 1]; ++piece) {
                m_partition.seedOfPiece[piece] = m_delaunay.seedOf[site];
            }
        }
    }

    bool isEachSiteOnePiece() const {
        std::uint32_t site = 0;
        return std::all_of(m_firstPieces.begin(), m_firstPieces.end(), [&](std::uint32_t p) { return p == site++; });
    }

    void replaceSitesByPieces(std::size_t k) {
        const std::size_t first = m_begins[k].rings, end = first + m_ranges[k].pieces.ringEnds.size();
        for (std::size_t ring = first; ring < end; ++ring) {
            const std::uint32_t ringBegin = m_partition.cornersOfRing[ring];
            const std::uint32_t ringEnd = m_partition.cornersOfRing[ring + 1];
            for (std::uint32_t corner = ringBegin; corner < ringEnd; ++corner) {
                std::uint32_t& neighbour = m_partition.neighbours[corner];
                if (neighbour == kNone) continue;
                const std::uint32_t next = m_partition.corners[corner + 1 < ringEnd ? corner + 1 : ringBegin];
                neighbour = pieceWithEdge(neighbour, {next, m_partition.corners[corner]});
            }
        }
    }

    /// The piece of a site's cell that has the edge.
    std::uint32_t pieceWithEdge(std::uint32_t site, PointEdge edge) const {
        if (isIndexed(site)) {
            const std::uint32_t found = m_edges.find(site, edge);
            return found == kNone ? m_firstPieces[site + 1] - 1 : found;
        }
        std::uint32_t piece = m_firstPieces[site];
        while (piece + 1 < m_firstPieces[site + 1] && !hasEdge(m_partition, piece, edge)) ++piece;
        return piece;
    }
    bool isIndexed(std::uint32_t site) const {
        return m_firstPieces[site + 1] - m_firstPieces[site] > EdgeIndex::kMaxLinear;
    }

    const Delaunay& m_delaunay;
    std::span<const CellRange> m_ranges;
    Partition& m_partition;
    std::vector<Offsets> m_begins;  // of each range
    Offsets m_end;
    UninitializedVector<std::uint32_t> m_firstPieces;  // of each site; one more at the end
    EdgeIndex m_edges;                                 // of sites with many pieces
};

Status clipCells(const Polygon& outline, const Delaunay& delaunay, const TaskContext& task, Partition& partition) {
    const LocalFrame frame = localFrame(outline);
    partition.origin = frame.origin;
    const std::vector<std::uint32_t> outgoing = outgoingHalfEdges(delaunay);
    const Result<OutlineTrace> traced = traceOutline(outline, delaunay, outgoing);
    if (!traced) return traced.error();
    const OutlineTrace& trace = *traced;
    const PointNumbers numbers = pointNumbers(delaunay, trace);
    partition.points.resize(numbers.count);
    computeCorners(delaunay, frame, task.threads, partition.points);
    computeOutlinePoints(delaunay, trace, frame, partition.points);

    const AcuteCorners acuteCorners(outline, frame);
    const CellSources sources = {outline, delaunay, outgoing, trace, numbers, frame, acuteCorners, partition.points};
    const std::size_t siteCount = delaunay.sites.size();
    std::vector<CellRange> ranges((siteCount + kSitesPerRange - 1) / kSitesPerRange);
    forEachIndex(ranges.size(), task.threads, [&](std::size_t k) {
        const IndexRange sites = chunkRange(siteCount, k, ranges.size());
        if (task.isCancelled()) return;
        ranges[k] =
            assembleCells(sources, static_cast<std::uint32_t>(sites.begin), static_cast<std::uint32_t>(sites.end));
    });
    if (task.isCancelled()) return TaskContext::cancelled();

    RangeConcatenation concatenation(delaunay, ranges, partition);
    concatenation.run(task.threads);
    Coincidences coincidences = concatenation.coincidences(numbers, frame.weldDistance);
    if (!coincidences.pairs.empty() || !coincidences.touches.empty()) {
        weldVertices(partition, std::move(coincidences));
    }
    return success();
}

Diagnostic report(DiagnosticCode code, std::uint32_t seed, std::uint32_t other, std::string message) {
    return diagnostic(code, {.seed = seed, .otherSeed = other}, std::move(message));
}

/// Fills pieceOfSeed and reports cells of several pieces. Returns the number of seeds that have a cell.
std::size_t findPiecesOfSeeds(Partition& partition, CappedDiagnostics& found) {
    const UninitializedVector<std::uint32_t>& seedOf = partition.seedOfPiece;
    std::size_t cells = 0;
    for (std::uint32_t first = 0, end = 0; first < seedOf.size(); first = end) {
        for (end = first + 1; end < seedOf.size() && seedOf[end] == seedOf[first];) ++end;
        if (seedOf[first] == kNone) continue;
        partition.pieceOfSeed[seedOf[first]] = first;
        ++cells;
        if (end - first == 1) continue;
        found.add(DiagnosticCode::SplitCell, [&] {
            return report(DiagnosticCode::SplitCell, seedOf[first], kNone,
                          "The outline cuts the cell of seed " + std::to_string(seedOf[first]) + " into " +
                              std::to_string(end - first) + " pieces.");
        });
    }
    return cells;
}

/// Fills pieceOfSeed and reports the seeds that have no piece or several.
void reportSeeds(const Delaunay& delaunay, Partition& partition) {
    partition.pieceOfSeed.assign(delaunay.sites.size() + delaunay.duplicates.size(), kNone);
    CappedDiagnostics found;
    const bool allHaveCells = findPiecesOfSeeds(partition, found) == delaunay.sites.size();
    for (const auto& duplicate : delaunay.duplicates) {
        found.add(DiagnosticCode::DuplicateSeed, [&] {
            const auto& [seed, of] = duplicate;
            return report(DiagnosticCode::DuplicateSeed, seed, of,
                          "Seed " + std::to_string(seed) + " equals seed " + std::to_string(of) + " and was left out.");
        });
    }
    for (const std::uint32_t seed : delaunay.seedOf) {
        if (allHaveCells) break;
        if (partition.pieceOfSeed[seed] != kNone) continue;
        found.add(DiagnosticCode::SeedWithoutCell, [&] {
            return report(DiagnosticCode::SeedWithoutCell, seed, kNone,
                          "Seed " + std::to_string(seed) + " has no cell inside the outline.");
        });
    }
    std::ranges::move(std::move(found).list(), std::back_inserter(partition.diagnostics));
    std::stable_sort(partition.diagnostics.begin(), partition.diagnostics.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.place.seed < b.place.seed; });
}

}  // namespace

Result<Partition> voronoiPartition(const Polygon& outline, const Delaunay& delaunay, const TaskContext& task) {
    Partition partition;
    if (delaunay.sites.size() < 2) {
        partition = wholeOutline(outline, delaunay.sites.empty() ? kNone : delaunay.seedOf[0]);
    } else if (const Status cut = clipCells(outline, delaunay, task, partition); !cut) {
        return cut.error();
    }
    reportSeeds(delaunay, partition);
    return partition;
}

Result<Partition> voronoiPartition(const Polygon& outline, std::span<const Vec2> seeds, const TaskContext& task) {
    const Result<Delaunay> delaunay = triangulate(seeds, task);
    if (!delaunay) return delaunay.error();
    return voronoiPartition(outline, *delaunay, task);
}

}  // namespace rubble
