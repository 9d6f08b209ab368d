#pragma once

#include "core/physics/WorkerTeam.h"
#include "core/physics/WorldState.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// All that regions found, ascending, in the first of them.
inline std::vector<std::uint32_t>& mergedAscending(std::vector<std::vector<std::uint32_t>>& byRegion) {
    for (std::size_t region = 1; region < byRegion.size(); ++region) {
        byRegion[0].insert(byRegion[0].end(), byRegion[region].begin(), byRegion[region].end());
    }
    std::sort(byRegion[0].begin(), byRegion[0].end());
    return byRegion[0];
}

/// The awake bodies cut by space into one region a worker, so that each finds the bodies and contacts of its region in its own
/// cache, pass after pass and step after step. Few contacts shall be of two regions: their bodies' cache lines go to and fro.
/// No result depends on regions.
class Regions {
public:
    /// Shares out who is awake now among so many workers, cutting anew where need be.
    void shareOut(const WorldState& state, int workers);
    /// Brings the contacts of each colour into order of their regions, now and then, as many come and go.
    void orderContacts(WorldState& state, WorkerTeam& team);

    std::size_t count() const { return m_bodies.size(); }
    /// The awake bodies of a region, ascending.
    std::span<const std::uint32_t> bodies(std::size_t region) const { return m_bodies[region]; }
    /// Calls work(region) for each, side by side.
    template <class Work>
    void forEach(WorkerTeam& team, const Work& work) const {
        team.shareStages(1, count(), [&](std::size_t, std::size_t region) { work(region); });
    }
    /// What a region has of the blocks of a list of ContactColours, or of what goes with them.
    template <class Block>
    std::span<Block> part(std::size_t list, std::span<Block> blocks, std::size_t region) const {
        const std::size_t begin = firstBlock(list, region, blocks.size());
        return blocks.subspan(begin, firstBlock(list, region + 1, blocks.size()) - begin);
    }

    /// Calls work(range) for such ranges of a region's `blocks` blocks as are best worked on at once, in their best order. Every other
    /// region goes backwards: a processor fetches what lies ahead, and shall not fetch it out of a neighbour's cache.
    template <class Work>
    void inTheirOrder(std::size_t blocks, std::size_t region, const Work& work) const {
        if (count() == 1 || region % 2 == 1) return work(IndexRange{0, blocks});
        for (std::size_t i = blocks; i-- > 0;) work(IndexRange{i, i + 1});
    }

private:
    static constexpr std::size_t kMost = 16;
    static constexpr std::size_t kCells = 16;  // of a region
    static_assert(kMost * kCells <= ContactColours::kMostCells);
    static constexpr std::uint16_t kNowhere = 0xFFFF;  // of static and kinematic bodies, which are in all of them

    std::size_t firstBlock(std::size_t list, std::size_t region, std::size_t blocks) const {
        if (region == 0) return 0;
        return region == count() ? blocks : std::min<std::size_t>(blocks, m_firstBlocks[list][region]);
    }
    void cut(const WorldState& state, std::span<std::uint32_t> bodies, int axis, std::size_t first, std::size_t cells);

    std::vector<std::vector<std::uint32_t>> m_bodies = std::vector<std::vector<std::uint32_t>>(1);
    std::vector<std::uint16_t> m_cellOf;  // by body; those of region r are kCells * r and the ones after
    std::vector<std::uint32_t> m_order;   // of awake bodies, as cut() left them
    std::vector<std::array<std::uint32_t, kMost>> m_firstBlocks;  // by list and region, as of the last order
    int m_callsSinceCut = 0;
    int m_callsSinceOrder = 0;
};

}  // namespace rubble
