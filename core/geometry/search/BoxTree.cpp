#include "core/geometry/search/BoxTree.h"

#include <algorithm>
#include <numeric>

namespace rubble {

BoxTree::BoxTree(std::span<const Box3> boxes) : m_items(boxes.size()) {
    std::iota(m_items.begin(), m_items.end(), 0u);
    std::vector<Vec3> centres;
    centres.reserve(boxes.size());
    for (const Box3& box : boxes) {
        centres.push_back(box.centre());
        for (int axis = 0; axis < 3; ++axis) {
            m_extent = std::max({m_extent, std::abs(box.min[axis]), std::abs(box.max[axis])});
        }
    }
    if (boxes.empty()) return;
    m_nodes.reserve(2 * boxes.size());
    m_nodes.emplace_back();
    split(0, 0, static_cast<std::uint32_t>(boxes.size()), boxes, centres);
    m_boxes.reserve(boxes.size());
    for (const std::uint32_t item : m_items) m_boxes.push_back(boxes[item]);
}

/// Splits at the median of the centres along the longest axis: at most log2(n) levels, well below the stack of a
/// search.
void BoxTree::split(std::uint32_t node, std::uint32_t first, std::uint32_t count, std::span<const Box3> boxes,
                    std::span<const Vec3> centres) {
    if (count <= kLeafSize) {
        Box3 box;
        for (std::uint32_t k = first; k < first + count; ++k) box.include(boxes[m_items[k]]);
        m_nodes[node] = {box, first, count};
        // The order in which nth_element leaves items depends on the standard library.
        std::sort(m_items.begin() + first, m_items.begin() + first + count);
        return;
    }
    Box3 spread;
    for (std::uint32_t k = first; k < first + count; ++k) spread.include(centres[m_items[k]]);
    const Vec3 size = spread.max - spread.min;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto begin = m_items.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        const double left = centres[a][axis], right = centres[b][axis];
        return left != right ? left < right : a < b;
    });
    const auto child = static_cast<std::uint32_t>(m_nodes.size());
    m_nodes.resize(m_nodes.size() + 2);
    split(child, first, count / 2, boxes, centres);
    split(child + 1, first + count / 2, count - count / 2, boxes, centres);
    Box3 box = m_nodes[child].box;
    box.include(m_nodes[child + 1].box);
    m_nodes[node] = {box, child, 0};
}

}  // namespace rubble
