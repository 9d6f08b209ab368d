#pragma once

#include "core/base/ThreadPool.h"
#include "core/physics/state/WorldState.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Empties the lists, and adds some if there are fewer than `count`. Lists are never removed, so that they keep their
/// memory through steps on fewer threads.
template <class T>
void clearLists(std::vector<std::vector<T>>& lists, std::size_t count) {
    if (lists.size() < count) lists.resize(count);
    for (std::vector<T>& list : lists) list.clear();
}

/// Concatenates the lists of all regions into the first and sorts it.
inline std::vector<std::uint32_t>& mergeSorted(std::vector<std::vector<std::uint32_t>>& byRegion) {
    for (std::size_t region = 1; region < byRegion.size(); ++region) {
        byRegion[0].insert(byRegion[0].end(), byRegion[region].begin(), byRegion[region].end());
    }
    std::sort(byRegion[0].begin(), byRegion[0].end());
    return byRegion[0];
}

/// A spatial partition of the awake bodies, one region per thread, so that each thread finds the bodies and contacts of
/// its region in its own cache from pass to pass and step to step. Contacts across regions should be few: the cache
/// lines of their bodies bounce between cores. No result depends on regions.
class Regions {
public:
    /// Assigns the awake bodies to `threads` regions, and recomputes the partition from time to time.
    void assignBodies(const WorldState& state, int threads);
    /// Sorts the contacts of each colour by region, from time to time.
    void sortContacts(WorldState& state, ThreadPool& threads);

    std::size_t count() const { return m_count; }
    /// The awake bodies of a region, ascending.
    std::span<const std::uint32_t> bodies(std::size_t region) const { return m_bodies[region]; }
    /// Calls work(region) for each region, in parallel.
    template <class Work>
    void forEach(ThreadPool& threads, const Work& work) const {
        threads.runStages(1, count(), [&](std::size_t, std::size_t region) { work(region); });
    }
    /// The part of the blocks of a ContactColours list, or of the references beside them, that belongs to a region.
    template <class Block>
    std::span<Block> part(std::size_t list, std::span<Block> blocks, std::size_t region) const {
        const std::size_t begin = firstBlock(list, region, blocks.size());
        return blocks.subspan(begin, firstBlock(list, region + 1, blocks.size()) - begin);
    }

    /// Calls work(range) for ranges that cover the `blocks` blocks of a region. Every other region is traversed
    /// backwards, so that hardware prefetching at its end does not take cache lines from the neighbouring region.
    template <class Work>
    void forEachBlockRange(std::size_t blocks, std::size_t region, const Work& work) const {
        if (count() == 1 || region % 2 == 1) return work(IndexRange{0, blocks});
        for (std::size_t i = blocks; i-- > 0;) work(IndexRange{i, i + 1});
    }

private:
    static constexpr std::size_t kMaxRegions = 16;
    static constexpr std::size_t kCells = 16;  // per region
    static_assert(kMaxRegions * kCells <= ContactColours::kMaxCells);
    static constexpr std::uint16_t kNoCell = 0xFFFF;  // of static and kinematic bodies

    std::size_t firstBlock(std::size_t list, std::size_t region, std::size_t blocks) const {
        if (region == 0) return 0;
        return region == count() ? blocks : std::min<std::size_t>(blocks, m_firstBlocks[list][region]);
    }
    void partition(const WorldState& state, std::span<std::uint32_t> bodies, int axis, std::size_t first,
                   std::size_t cells);

    std::size_t m_count = 1;
    std::vector<std::vector<std::uint32_t>> m_bodies;  // by region, and empty lists behind them
    std::vector<std::uint16_t> m_cellOf;               // by body; region r has the cells [kCells * r, kCells * (r + 1))
    std::vector<std::uint32_t> m_order;                // the awake dynamic bodies, in the order of their cells
    std::vector<std::array<std::uint32_t, kMaxRegions>> m_firstBlocks;  // by list and region, as of the last sort
    int m_callsSincePartition = 0;
    int m_callsSinceSort = 0;
};

}  // namespace rubble
