#include "core/geometry/mesh/TriangleTree.h"

#include "core/base/Parallel.h"

#include <algorithm>
#include <numeric>

namespace rubble {
namespace {

constexpr std::size_t kBlockSize = 8192;

/// The triangles by places, split at medians until blocks are small enough.
std::vector<IndexRange> splitIntoBlocks(std::vector<std::uint32_t>& order, const std::vector<Vec3>& centres,
                                        const TaskContext& task) {
    std::vector<IndexRange> ranges = {{0, order.size()}};
    while (ranges[0].size() > kBlockSize && !task.isCancelled()) {
        std::vector<IndexRange> halves(2 * ranges.size());
        forEachIndex(ranges.size(), task.threads, [&](std::size_t r) {
            const IndexRange range = ranges[r];
            Box3 spread;
            for (std::size_t k = range.begin; k < range.end; ++k) spread.include(centres[order[k]]);
            const Vec3 size = spread.max - spread.min;
            const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            const std::size_t middle = range.begin + range.size() / 2;
            const auto at = [&](std::size_t k) { return order.begin() + static_cast<std::ptrdiff_t>(k); };
            std::nth_element(at(range.begin), at(middle), at(range.end), [&](std::uint32_t a, std::uint32_t b) {
                const double left = centres[a][axis], right = centres[b][axis];
                return left != right ? left < right : a < b;
            });
            halves[2 * r] = {range.begin, middle};
            halves[2 * r + 1] = {middle, range.end};
        });
        ranges = std::move(halves);
    }
    return ranges;
}

}  // namespace

Result<TriangleTree> TriangleTree::make(const LatticeSurface& surface, const TaskContext& task) {
    const std::size_t count = surface.triangles.size();
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::vector<Vec3> centres(count);
    for (std::uint32_t t = 0; t < count; ++t) centres[t] = surface.boxOf(t).centre();
    const std::vector<IndexRange> ranges = splitIntoBlocks(order, centres, task);
    if (task.isCancelled()) return TaskContext::cancelled();

    std::vector<std::optional<Block>> blocks(ranges.size());
    forEachIndex(ranges.size(), task.threads, [&](std::size_t r) {
        if (task.isCancelled()) return;
        const auto [begin, end] = ranges[r];
        std::vector<std::uint32_t> triangles(order.begin() + static_cast<std::ptrdiff_t>(begin),
                                             order.begin() + static_cast<std::ptrdiff_t>(end));
        std::ranges::sort(triangles);  // the order that nth_element leaves depends on the standard library
        std::vector<Box3> boxes;
        Box3 box;
        for (const std::uint32_t t : triangles) {
            boxes.push_back(surface.boxOf(t));
            box.include(boxes.back());
        }
        blocks[r] = Block{std::move(triangles), BoxTree(boxes), box};
    });
    if (task.isCancelled()) return TaskContext::cancelled();
    TriangleTree tree;
    std::vector<Box3> boxes;
    for (std::optional<Block>& block : blocks) {
        boxes.push_back(block->box);
        tree.m_blocks.push_back(std::move(*block));
    }
    tree.m_top.emplace(boxes);
    return tree;
}

}  // namespace rubble
