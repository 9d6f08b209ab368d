#pragma once

#include "core/fracture/Delaunay.h"
#include "core/fracture/Partition.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rubble {

/// Where a seed is to stand.
struct MovedSeed {
    std::uint32_t seed = 0;
    Vec2 position{0.0, 0.0};
};

/// A part of a pattern whose seeds have moved: enough seeds around them to make the cells that changed.
struct LocalCells {
    std::vector<std::uint32_t> seeds;     // ascending: seed k of what follows is seeds[k] of the whole pattern
    std::vector<std::uint32_t> complete;  // of 0, 1, …, seeds.size() - 1, ascending: whose cells are those of the whole
    std::vector<Vec2> positions;          // one a seed
    Delaunay triangulation;               // of these seeds
    Partition partition;                  // of the whole outline by these seeds
};

/// Finds the cells that change when seeds move, in time that depends on these cells and on the outline alone.
///
/// A cell is fixed by the sites it touches. A moved seed changes the cells that touched its old one and those that its new
/// one is cut out of, whose corners' circles hold its new place. So these seeds and all that they are joined to give the same
/// cells as all seeds do: the same pieces and neighbours, with corners that differ by no more than two roundings
/// (kConstructionError), because a circumcentre depends on which of its three sites is called the first.
class LocalDiagram {
public:
    /// Of the seeds as they stand, in linear time. Both are borrowed.
    LocalDiagram(std::span<const Vec2> positions, const Delaunay& delaunay);

    /// The cells around seeds that move; all cells they change are complete. `moved` names each seed once; the outline is
    /// validated().
    ///
    /// Errors: BadInput where a position is not finite, naming the seed.
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
    std::vector<std::uint32_t>
        m_siteOf;                   // of each seed; of an equal one that was left out, the site of the one that stayed
    std::uint32_t m_inner = kNone;  // a triangle that is no ghost; kNone where all sites lie on one line
};

}  // namespace rubble
