#include "core/fracture/VoronoiPartition.h"

#include "core/fracture/OutlineTrace.h"
#include "core/fracture/PartitionRepair.h"
#include "core/fracture/VisitedCell.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace rubble {

namespace {

constexpr double kCoincident = 0x1p-46;  // of the reach; four times what two constructions can be off
constexpr std::uint32_t kCellsBetweenCancelChecks = 4096;

/// An origin that can be subtracted from the outline without rounding: an axis keeps 0 unless the outline lies farther
/// from it than it is wide, and then all its coordinates are within a factor of two of each other.
Vec2 exactOrigin(const Polygon& outline) {
    const Box2 box = boundsOf(outline.outer);
    const auto isFar = [](double min, double max) {
        return std::min(std::abs(min), std::abs(max)) >= max - min && min * max > 0.0;
    };
    return {isFar(box.min.x, box.max.x) ? outline.outer[0].x : 0.0,
            isFar(box.min.y, box.max.y) ? outline.outer[0].y : 0.0};
}

/// The largest coordinate of the outline relative to the origin.
double reachOf(const Polygon& outline, Vec2 origin) {
    double reach = 0.0;
    for (const Vec2 point : outline.outer) {
        reach = std::max({reach, std::abs(point.x - origin.x), std::abs(point.y - origin.y)});
    }
    return reach;
}

/// The outline as the only piece.
Partition wholeOutline(const Polygon& outline, std::uint32_t seed) {
    Partition partition;
    partition.origin = exactOrigin(outline);
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

enum class CellPlace : std::uint8_t { Unknown, Inside, Outside };

/// Puts the partition together, cell by cell in the order of the sites. While it does so, `across` and the pairs of
/// pieces hold sites; the last step turns them into pieces.
class Assembler {
public:
    Assembler(const Polygon& outline, const Delaunay& delaunay, Partition& partition)
        : m_outline(outline),
          m_delaunay(delaunay),
          m_partition(partition),
          m_outgoing(outgoingHalfEdges(delaunay)),
          m_trace(traceOutline(outline, delaunay, m_outgoing)) {
        partition.origin = exactOrigin(outline);
        m_reach = reachOf(outline, partition.origin);
        m_numbers.vertices = static_cast<std::uint32_t>(delaunay.triangles.size());
        m_numbers.crossings = m_numbers.vertices + static_cast<std::uint32_t>(m_trace.vertices.size());
        m_coincident = {{}, {}, m_numbers.vertices, m_numbers.crossings, kCoincident * m_reach};
    }

    Status assemble(const TaskContext& task) {
        computePoints();
        if (const Status done = addCells(task); !done) return done;
        nameNeighboursByPiece();
        if (!m_coincident.pairs.empty() || !m_coincident.touches.empty()) {
            joinCoincidences(m_partition, std::move(m_coincident));
        }
        return success();
    }

private:
    void computePoints() {
        std::vector<Vec2>& points = m_partition.points;
        points.reserve(m_numbers.crossings + m_trace.crossings.size());
        computeCorners();
        for (const Vec2 vertex : m_trace.vertices) points.push_back(vertex - m_partition.origin);
        for (const OutlineCrossing& crossing : m_trace.crossings) {
            points.push_back(crossingWithBisector(
                m_trace.lineOf(crossing), m_delaunay.sites[m_delaunay.origin(crossing.halfEdge)],
                m_delaunay.sites[targetOf(m_delaunay, crossing.halfEdge)], m_partition.origin, m_reach));
        }
    }

    /// The circumcentres in the order of the triangles, and which neighbours' coincide: those on one circle.
    void computeCorners() {
        std::vector<Vec2>& points = m_partition.points;
        const std::vector<Vec2>& sites = m_delaunay.sites;
        const std::uint32_t count = static_cast<std::uint32_t>(m_delaunay.triangles.size());
        for (std::uint32_t t = 0; t < count; ++t) {
            const Delaunay::Triangle& triangle = m_delaunay.triangles[t];
            const std::uint32_t* corner = triangle.corner;
            if (corner[0] == Delaunay::kGhost || corner[1] == Delaunay::kGhost || corner[2] == Delaunay::kGhost) {
                points.push_back({HUGE_VAL, HUGE_VAL});
                continue;
            }
            points.push_back(
                circumcentre(sites[corner[0]], sites[corner[1]], sites[corner[2]], m_partition.origin, m_reach));
            for (const std::uint32_t twin : triangle.twin) {
                if (twin >> 2 < t) noteIfCoincident(twin >> 2, t);
            }
        }
    }

    void noteIfCoincident(std::uint32_t a, std::uint32_t b) {
        const Vec2 offset = m_partition.points[a] - m_partition.points[b];
        if (std::abs(offset.x) <= m_coincident.distance && std::abs(offset.y) <= m_coincident.distance) {
            m_coincident.pairs.push_back({a, b});
        }
    }

    Status addCells(const TaskContext& task) {
        const std::uint32_t count = static_cast<std::uint32_t>(m_delaunay.sites.size());
        CellCutter cutter(m_delaunay, m_outgoing, m_trace, m_numbers, m_partition.points);
        CellPieces pieces;
        m_places.assign(count, CellPlace::Unknown);
        m_firstPiece.reserve(count + 1);
        reserve(count);
        for (std::uint32_t site = 0; site < count; ++site) {
            if (site % kCellsBetweenCancelChecks == 0 && task.isCancelled()) return TaskContext::cancelled();
            m_firstPiece.push_back(m_partition.pieceCount());
            if (m_trace.firstPassage[site] != kNone) {
                cutter.cut(site, pieces);
                addPieces(site, pieces);
                noteTouchingVertices(site);
            } else if (placeOf(site) == CellPlace::Inside) {
                addWholeCell(site);
            }
        }
        m_firstPiece.push_back(m_partition.pieceCount());
        return success();
    }

    void reserve(std::uint32_t cells) {
        m_partition.seedOfPiece.reserve(cells);
        m_partition.ringsOfPiece.reserve(cells + 1);
        m_partition.cornersOfRing.reserve(cells + 1);
        m_partition.corners.reserve(6 * std::size_t{cells} + 4 * m_trace.crossings.size());
        m_partition.across.reserve(m_partition.corners.capacity());
        m_partition.ringsOfPiece.push_back(0);
        m_partition.cornersOfRing.push_back(0);
    }

    /// A cell that the outline does not enter is inside where its site is; so are its neighbours of that kind.
    CellPlace placeOf(std::uint32_t site) {
        const std::uint32_t first = m_outgoing[site];
        std::uint32_t spoke = first;
        do {
            const std::uint32_t neighbour = targetOf(m_delaunay, spoke);
            if (neighbour != Delaunay::kGhost && m_places[neighbour] != CellPlace::Unknown)
                return m_places[site] = m_places[neighbour];
            spoke = nextAround(m_delaunay, spoke);
        } while (spoke != first);
        const bool isInside = containment(m_outline, m_delaunay.sites[site]) != Containment::Outside;
        return m_places[site] = isInside ? CellPlace::Inside : CellPlace::Outside;
    }

    void addWholeCell(std::uint32_t site) {
        const std::uint32_t first = m_outgoing[site];
        std::uint32_t spoke = first;
        do {
            const Delaunay::Triangle& triangle = m_delaunay.triangles[spoke >> 2];
            const std::uint32_t back = Delaunay::previous(spoke) & 3;
            m_partition.corners.push_back(spoke >> 2);
            m_partition.across.push_back(triangle.corner[back]);
            spoke = triangle.twin[back];
        } while (spoke != first);
        endRing();
        endPiece(site);
    }

    void addPieces(std::uint32_t site, const CellPieces& pieces) {
        std::uint32_t corner = 0, ring = 0;
        for (const std::uint32_t pieceEnd : pieces.pieceEnds) {
            for (; ring < pieceEnd; ++ring) {
                const std::uint32_t begin = corner;
                for (; corner < pieces.ringEnds[ring]; ++corner) {
                    m_partition.corners.push_back(pieces.corners[corner].point);
                    m_partition.across.push_back(pieces.corners[corner].across);
                    const std::uint32_t next = corner + 1 < pieces.ringEnds[ring] ? corner + 1 : begin;
                    noteIfCoincident(pieces.corners[corner].point, pieces.corners[next].point);
                }
                endRing();
            }
            endPiece(site);
        }
    }

    /// Vertices of the outline that lie on a bisector of their cell, at the precision of the coordinates.
    void noteTouchingVertices(std::uint32_t site) {
        if (m_firstPiece[site] == m_partition.pieceCount()) return;
        for (std::uint32_t p = m_trace.firstPassage[site]; p != kNone; p = m_trace.passages[p].nextInCell) {
            const OutlinePassage& passage = m_trace.passages[p];
            const std::uint32_t begin = m_trace.ringStarts[passage.ring], end = m_trace.ringStarts[passage.ring + 1];
            for (std::uint32_t i = 0, vertex = passage.firstVertex; i < passage.vertexCount; ++i) {
                if (isOnBisector(site, m_trace.vertices[vertex])) {
                    m_coincident.touches.push_back(
                        {m_numbers.vertices + vertex, m_firstPiece[site], m_partition.pieceCount() - 1});
                }
                vertex = vertex + 1 == end ? begin : vertex + 1;
            }
        }
    }

    bool isOnBisector(std::uint32_t site, Vec2 point) const {
        const Vec2 toSite = m_delaunay.sites[site] - point;
        const std::uint32_t first = m_outgoing[site];
        std::uint32_t spoke = first;
        do {
            const std::uint32_t neighbour = targetOf(m_delaunay, spoke);
            spoke = nextAround(m_delaunay, spoke);
            if (neighbour == Delaunay::kGhost) continue;
            const Vec2 toNeighbour = m_delaunay.sites[neighbour] - point, apart = toNeighbour - toSite;
            // The distance to the bisector times twice the sites' distance.
            const double product = apart.x * (toSite.x + toNeighbour.x) + apart.y * (toSite.y + toNeighbour.y);
            const double limit = 2.0 * m_coincident.distance;
            if (product * product <= limit * limit * (apart.x * apart.x + apart.y * apart.y)) return true;
        } while (spoke != first);
        return false;
    }

    void endRing() { m_partition.cornersOfRing.push_back(static_cast<std::uint32_t>(m_partition.corners.size())); }
    void endPiece(std::uint32_t site) {
        m_partition.ringsOfPiece.push_back(static_cast<std::uint32_t>(m_partition.cornersOfRing.size()) - 1);
        m_partition.seedOfPiece.push_back(m_delaunay.seedOf[site]);
    }

    void nameNeighboursByPiece() {
        const std::uint32_t count = static_cast<std::uint32_t>(m_delaunay.sites.size());
        bool isIdentity = m_partition.pieceCount() == count;
        for (std::uint32_t site = 0; site < count && isIdentity; ++site) isIdentity = m_firstPiece[site] == site;
        if (isIdentity) return;
        for (std::uint32_t piece = 0; piece < m_partition.pieceCount(); ++piece) {
            for (std::uint32_t ring = m_partition.ringsOfPiece[piece]; ring < m_partition.ringsOfPiece[piece + 1];
                 ++ring) {
                const std::uint32_t begin = m_partition.cornersOfRing[ring], end = m_partition.cornersOfRing[ring + 1];
                for (std::uint32_t corner = begin; corner < end; ++corner) {
                    std::uint32_t& across = m_partition.across[corner];
                    if (across == kNone) continue;
                    const std::uint32_t next = m_partition.corners[corner + 1 < end ? corner + 1 : begin];
                    across = pieceWithEdge(across, next, m_partition.corners[corner]);
                }
            }
        }
    }

    /// Which piece of a site's cell has the edge from one point to another.
    std::uint32_t pieceWithEdge(std::uint32_t site, std::uint32_t from, std::uint32_t to) const {
        std::uint32_t piece = m_firstPiece[site];
        while (piece + 1 < m_firstPiece[site + 1] && !hasEdge(m_partition, piece, from, to)) ++piece;
        return piece;
    }

    const Polygon& m_outline;
    const Delaunay& m_delaunay;
    Partition& m_partition;
    std::vector<std::uint32_t> m_outgoing;
    OutlineTrace m_trace;
    PointNumbers m_numbers;
    Coincidences m_coincident;
    double m_reach = 0.0;
    std::vector<CellPlace> m_places;
    std::vector<std::uint32_t> m_firstPiece;  // of each site; one more at the end
};

std::string countOf(std::uint32_t count, const char* what) { return std::to_string(count) + " " + what; }

/// Fills pieceOfSeed and says which seeds have no piece or several.
void reportSeeds(const Delaunay& delaunay, Partition& partition) {
    std::vector<std::uint32_t>& pieceOfSeed = partition.pieceOfSeed;
    pieceOfSeed.assign(delaunay.sites.size() + delaunay.duplicates.size(), kNone);
    for (std::uint32_t piece = partition.pieceCount(); piece-- > 0;) {
        if (partition.seedOfPiece[piece] != kNone) pieceOfSeed[partition.seedOfPiece[piece]] = piece;
    }
    const auto report = [&](ReportCode code, std::uint32_t seed, std::uint32_t of, std::string message) {
        partition.reports.push_back({code, seed, of, 0.0, std::move(message)});
    };
    for (const auto& [seed, of] : delaunay.duplicates) {
        report(ReportCode::DuplicateSeed, seed, of,
               "Seed " + std::to_string(seed) + " equals seed " + std::to_string(of) + " and was left out.");
    }
    for (const std::uint32_t seed : delaunay.seedOf) {
        const std::uint32_t first = pieceOfSeed[seed];
        if (first == kNone) {
            report(ReportCode::SeedWithoutCell, seed, kNone,
                   "Seed " + std::to_string(seed) + " has no cell inside the outline.");
            continue;
        }
        std::uint32_t end = first + 1;
        while (end < partition.pieceCount() && partition.seedOfPiece[end] == seed) ++end;
        if (end - first > 1) {
            report(ReportCode::SplitCell, seed, kNone,
                   "The outline cuts the cell of seed " + std::to_string(seed) + " into " +
                       countOf(end - first, "pieces."));
        }
    }
    std::stable_sort(partition.reports.begin(), partition.reports.end(),
                     [](const Report& a, const Report& b) { return a.seed < b.seed; });
}

}  // namespace

Result<Partition> voronoiPartition(const Polygon& outline, const Delaunay& delaunay, const TaskContext& task) {
    Partition partition;
    if (delaunay.sites.size() < 2) {
        partition = wholeOutline(outline, delaunay.sites.empty() ? kNone : delaunay.seedOf[0]);
    } else if (Status assembled = Assembler(outline, delaunay, partition).assemble(task); !assembled) {
        return assembled.error();
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
