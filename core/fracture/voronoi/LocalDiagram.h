#pragma once

#include "core/fracture/delaunay/Delaunay.h"
#include "core/fracture/partition/Partition.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rubble {

/// A seed and its new position.
struct MovedSeed {
    std::uint32_t seed = 0;
    Vec2 position{0.0, 0.0};
};

/// The part of a pattern around seeds that have moved: enough seeds to compute the cells that changed.
struct LocalCells {
    std::vector<std::uint32_t> seeds;     // ascending: seed k below is seeds[k] of the whole pattern
    std::vector<std::uint32_t> complete;  // ascending indices into `seeds`: their cells are those of the whole pattern
    std::vector<Vec2> positions;          // one per seed
    Delaunay triangulation;               // of these seeds
    Partition partition;                  // of the whole outline, by these seeds
};

/// Computes the cells that change when seeds move, in time that depends only on these cells and the outline.
///
/// A cell is determined by its neighbours. A moved seed changes the neighbours of its old cell, and the cells that its
/// new cell is cut out of: those at the triangles whose circles contain the new position. These seeds and their
/// neighbours give the same cells as all seeds: the same pieces and neighbours, with corners that differ by at most two
/// roundings (kConstructionError), because a circumcentre depends on the order of its three sites.
class LocalDiagram {
public:
    /// Both arguments are borrowed. Linear time.
    LocalDiagram(std::span<const Vec2> positions, const Delaunay& delaunay);

    /// The cells around moved seeds; all cells that change are complete. Each seed occurs once in `moved`; the outline
    /// is validated().
    ///
    /// Errors: BadInput if a position is not finite, naming the seed.
    Result<LocalCells> cellsAround(const Polygon& outline, std::span<const MovedSeed> moved) const;

private:
    using Seeds = std::vector<std::uint32_t>;

    void addNeighbours(std::uint32_t seed, Seeds& seeds) const;
    void addCut(Vec2 position, std::uint32_t start, Seeds& seeds) const;
    void addDuplicates(Seeds& seeds) const;
    Seeds changedBy(std::span<const MovedSeed> moved) const;
    std::uint32_t triangleAt(Vec2 position, std::uint32_t start) const;
    std::uint32_t triangleBeside(std::uint32_t seed) const;
    bool isCut(std::uint32_t triangle, Vec2 position) const;

    std::span<const Vec2> m_positions;
    const Delaunay& m_delaunay;
    std::vector<std::uint32_t> m_outgoing;  // a half-edge of each site
    std::vector<std::uint32_t> m_siteOf;    // of each seed; of a duplicate, the site of the seed that it equals
    std::uint32_t m_inner = kNone;          // a triangle that is not a ghost; kNone if all sites are collinear
};

}  // namespace rubble
