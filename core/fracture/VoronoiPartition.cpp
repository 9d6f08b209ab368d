#include "core/fracture/VoronoiPartition.h"

#include "core/base/Parallel.h"
#include "core/fracture/CellAssembly.h"

#include <algorithm>
#include <string>

namespace rubble {

namespace {

constexpr std::uint32_t kSitesInStretch = 4096;

/// The outline as the only piece.
Partition wholeOutline(const Polygon& outline, std::uint32_t seed) {
    Partition partition;
    partition.origin = frameOf(outline).origin;
    partition.seedOfPiece = {seed};
    partition.cornersOfRing = {0};
    const auto addRing = [&](const Ring& ring) {
        for (const Vec2 point : ring) {
            partition.corners.push_back(static_cast<std::uint32_t>(partition.points.size()));
            partition.across.push_back(kNone);
            partition.points.push_back(point - partition.origin);
        }
        partition.cornersOfRing.push_back(static_cast<std::uint32_t>(partition.corners.size()));
    };
    addRing(outline.outer);
    for (const Ring& hole : outline.holes) addRing(hole);
    partition.ringsOfPiece = {0, static_cast<std::uint32_t>(outline.holes.size()) + 1};
    return partition;
}

/// Puts stretches of cells one after the other into a partition. The last step turns sites in `across` and in touches into
/// pieces.
class Joiner {
public:
    Joiner(const Delaunay& delaunay, std::span<const CellStretch> stretches, Partition& partition)
        : m_delaunay(delaunay), m_stretches(stretches), m_partition(partition) {
        for (const CellStretch& stretch : stretches) {
            m_begins.push_back(m_end);
            m_end.corners += stretch.pieces.corners.size();
            m_end.rings += stretch.pieces.ringEnds.size();
            m_end.pieces += stretch.pieces.pieceEnds.size();
        }
        partition.corners.resize(m_end.corners);
        partition.across.resize(m_end.corners);
        partition.cornersOfRing.resize(m_end.rings + 1);
        partition.ringsOfPiece.resize(m_end.pieces + 1);
        partition.seedOfPiece.resize(m_end.pieces);
        partition.cornersOfRing[0] = partition.ringsOfPiece[0] = 0;
        m_firstPieces.resize(delaunay.sites.size() + 1);
        m_firstPieces.back() = static_cast<std::uint32_t>(m_end.pieces);
    }

    void join(int threads) {
        forEachIndex(m_stretches.size(), threads, [this](std::size_t k) { copy(k); });
        if (isEachSiteOnePiece()) return;
        forEachIndex(m_stretches.size(), threads, [this](std::size_t k) { nameNeighboursByPiece(k); });
    }

    Coincidences coincidences(const PointNumbers& numbers, double distance) const {
        Coincidences all = {{}, {}, numbers.vertices, numbers.crossings, distance};
        for (std::size_t k = 0; k < m_stretches.size(); ++k) {
            const CellStretch& stretch = m_stretches[k];
            all.pairs.insert(all.pairs.end(), stretch.coincident.begin(), stretch.coincident.end());
            const std::uint32_t begin = static_cast<std::uint32_t>(m_begins[k].pieces);
            for (const TouchingVertex& touch : stretch.touches) {
                all.touches.push_back({touch.point, begin + touch.firstPiece, begin + touch.lastPiece});
            }
        }
        return all;
    }

private:
    struct Place {
        std::size_t corners = 0, rings = 0, pieces = 0;
    };

    void copy(std::size_t k) {
        const CellStretch& stretch = m_stretches[k];
        const Place begin = m_begins[k];
        for (std::size_t i = 0; i < stretch.pieces.corners.size(); ++i) {
            m_partition.corners[begin.corners + i] = stretch.pieces.corners[i].point;
            m_partition.across[begin.corners + i] = stretch.pieces.corners[i].across;
        }
        for (std::size_t i = 0; i < stretch.pieces.ringEnds.size(); ++i) {
            m_partition.cornersOfRing[begin.rings + i + 1] =
                static_cast<std::uint32_t>(begin.corners + stretch.pieces.ringEnds[i]);
        }
        for (std::size_t i = 0; i < stretch.pieces.pieceEnds.size(); ++i) {
            m_partition.ringsOfPiece[begin.pieces + i + 1] =
                static_cast<std::uint32_t>(begin.rings + stretch.pieces.pieceEnds[i]);
        }
        for (std::size_t i = 0; i + 1 < stretch.firstPieces.size(); ++i) {
            const std::size_t site = stretch.firstSite + i;
            const std::size_t first = begin.pieces + stretch.firstPieces[i];
            m_firstPieces[site] = static_cast<std::uint32_t>(first);
            for (std::size_t piece = first; piece < begin.pieces + stretch.firstPieces[i + 1]; ++piece) {
                m_partition.seedOfPiece[piece] = m_delaunay.seedOf[site];
            }
        }
    }

    bool isEachSiteOnePiece() const {
        std::uint32_t site = 0;
        return std::all_of(m_firstPieces.begin(), m_firstPieces.end(), [&](std::uint32_t p) { return p == site++; });
    }

    void nameNeighboursByPiece(std::size_t k) {
        const std::size_t first = m_begins[k].rings, end = first + m_stretches[k].pieces.ringEnds.size();
        for (std::size_t ring = first; ring < end; ++ring) {
            const std::uint32_t ringBegin = m_partition.cornersOfRing[ring];
            const std::uint32_t ringEnd = m_partition.cornersOfRing[ring + 1];
            for (std::uint32_t corner = ringBegin; corner < ringEnd; ++corner) {
                std::uint32_t& across = m_partition.across[corner];
                if (across == kNone) continue;
                const std::uint32_t next = m_partition.corners[corner + 1 < ringEnd ? corner + 1 : ringBegin];
                across = pieceWithEdge(across, next, m_partition.corners[corner]);
            }
        }
    }

    /// Which piece of a site's cell has the edge from one point to another.
    std::uint32_t pieceWithEdge(std::uint32_t site, std::uint32_t from, std::uint32_t to) const {
        std::uint32_t piece = m_firstPieces[site];
        while (piece + 1 < m_firstPieces[site + 1] && !hasEdge(m_partition, piece, from, to)) ++piece;
        return piece;
    }

    const Delaunay& m_delaunay;
    std::span<const CellStretch> m_stretches;
    Partition& m_partition;
    std::vector<Place> m_begins;  // of each stretch
    Place m_end;
    RawVector<std::uint32_t> m_firstPieces;  // of each site; one more at the end
};

Status cutIntoCells(const Polygon& outline, const Delaunay& delaunay, const TaskContext& task, Partition& partition) {
    const PointFrame frame = frameOf(outline);
    partition.origin = frame.origin;
    const std::vector<std::uint32_t> outgoing = outgoingHalfEdges(delaunay);
    const OutlineTrace trace = traceOutline(outline, delaunay, outgoing);
    const PointNumbers numbers = pointNumbers(delaunay, trace);
    partition.points.resize(numbers.count);
    computeCorners(delaunay, frame, task.threads, partition.points);
    computeOutlinePoints(delaunay, trace, frame, partition.points);

    const OutlineTips tips(outline, frame);
    const CellSources sources = {outline, delaunay, outgoing, trace, numbers, frame, tips, partition.points};
    const std::size_t siteCount = delaunay.sites.size();
    std::vector<CellStretch> stretches((siteCount + kSitesInStretch - 1) / kSitesInStretch);
    forEachIndex(stretches.size(), task.threads, [&](std::size_t k) {
        const IndexRange sites = partOf(siteCount, k, stretches.size());
        if (task.isCancelled()) return;
        stretches[k] =
            assembledCells(sources, static_cast<std::uint32_t>(sites.begin), static_cast<std::uint32_t>(sites.end));
    });
    if (task.isCancelled()) return TaskContext::cancelled();

    Joiner joiner(delaunay, stretches, partition);
    joiner.join(task.threads);
    Coincidences coincidences = joiner.coincidences(numbers, frame.joinDistance);
    if (!coincidences.pairs.empty() || !coincidences.touches.empty()) {
        joinCoincidences(partition, std::move(coincidences));
    }
    return success();
}

void report(Partition& partition, ReportCode code, std::uint32_t seed, std::uint32_t of, std::string message) {
    partition.reports.push_back({code, seed, of, 0.0, std::move(message)});
}

/// Fills pieceOfSeed and reports cells of several pieces; gives the number of seeds that have a cell.
std::size_t findPiecesOfSeeds(Partition& partition) {
    const RawVector<std::uint32_t>& seedOf = partition.seedOfPiece;
    std::size_t cells = 0;
    for (std::uint32_t first = 0, end = 0; first < seedOf.size(); first = end) {
        for (end = first + 1; end < seedOf.size() && seedOf[end] == seedOf[first];) ++end;
        if (seedOf[first] == kNone) continue;
        partition.pieceOfSeed[seedOf[first]] = first;
        ++cells;
        if (end - first == 1) continue;
        report(partition, ReportCode::SplitCell, seedOf[first], kNone,
               "The outline cuts the cell of seed " + std::to_string(seedOf[first]) + " into " +
                   std::to_string(end - first) + " pieces.");
    }
    return cells;
}

/// Fills pieceOfSeed and says which seeds have no piece or several.
void reportSeeds(const Delaunay& delaunay, Partition& partition) {
    partition.pieceOfSeed.assign(delaunay.sites.size() + delaunay.duplicates.size(), kNone);
    const bool allHaveCells = findPiecesOfSeeds(partition) == delaunay.sites.size();
    for (const auto& [seed, of] : delaunay.duplicates) {
        report(partition, ReportCode::DuplicateSeed, seed, of,
               "Seed " + std::to_string(seed) + " equals seed " + std::to_string(of) + " and was left out.");
    }
    for (const std::uint32_t seed : delaunay.seedOf) {
        if (allHaveCells) break;
        if (partition.pieceOfSeed[seed] != kNone) continue;
        report(partition, ReportCode::SeedWithoutCell, seed, kNone,
               "Seed " + std::to_string(seed) + " has no cell inside the outline.");
    }
    std::stable_sort(partition.reports.begin(), partition.reports.end(),
                     [](const Report& a, const Report& b) { return a.seed < b.seed; });
}

}  // namespace

Result<Partition> voronoiPartition(const Polygon& outline, const Delaunay& delaunay, const TaskContext& task) {
    Partition partition;
    if (delaunay.sites.size() < 2) {
        partition = wholeOutline(outline, delaunay.sites.empty() ? kNone : delaunay.seedOf[0]);
    } else if (const Status cut = cutIntoCells(outline, delaunay, task, partition); !cut) {
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
