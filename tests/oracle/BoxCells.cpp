#include "tests/oracle/BoxCells.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#include <voro++/voro++.hh>
#pragma GCC diagnostic pop

#include <algorithm>
#include <numeric>

namespace rubble::oracle {

std::vector<BoxCell> boxCells(const Box3& box, std::span<const Vec3> seeds) {
    constexpr int kBlocks = 6, kRoom = 8;  // in each direction; for seeds of a block, at first
    voro::container container(box.min.x, box.max.x, box.min.y, box.max.y, box.min.z, box.max.z, kBlocks, kBlocks,
                              kBlocks, false, false, false, kRoom);
    for (std::size_t seed = 0; seed < seeds.size(); ++seed) {
        container.put(static_cast<int>(seed), seeds[seed].x, seeds[seed].y, seeds[seed].z);
    }
    std::vector<BoxCell> cells(seeds.size());
    voro::c_loop_all loop(container);
    voro::voronoicell_neighbor cell;
    if (!loop.start()) return cells;
    do {
        if (!container.compute_cell(cell, loop)) continue;
        BoxCell& result = cells[static_cast<std::size_t>(loop.pid())];
        result.volume = cell.volume();
        std::vector<int> neighbours;
        std::vector<double> areas;
        cell.neighbors(neighbours);
        cell.face_areas(areas);
        std::vector<std::size_t> order(neighbours.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::sort(order, {}, [&](std::size_t k) { return neighbours[k]; });
        for (const std::size_t k : order) {
            if (neighbours[k] < 0) continue;  // a wall of the box
            result.neighbours.push_back(static_cast<std::uint32_t>(neighbours[k]));
            result.areas.push_back(areas[k]);
        }
    } while (loop.inc());
    return cells;
}

}  // namespace rubble::oracle
