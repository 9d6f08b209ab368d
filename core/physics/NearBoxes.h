#pragma once

#include "core/physics/BoxTree.h"

namespace rubble {

/// Boxes of a tree, to be tried by several others that lie close together: side by side, so that many are tried at once.
class NearBoxes {
public:
    /// Those that overlap a box.
    void gather(const BoxTree& tree, const Box& around);

    /// The numbers of those that overlap a box, in the order of BoxTree::visitOverlapping(); the caller's until the next call.
    std::span<const std::uint32_t> overlapping(const Box& box);

    std::size_t size() const { return m_count; }

private:
    struct Rows {
        std::vector<float> x, y, z;
        void resize(std::size_t size);
    };

    void add(std::uint32_t number, const Box& box);
    void tryAll(const Box& box);

    std::size_t m_count = 0;
    std::vector<std::uint32_t> m_numbers;  // this and the others: longer than the count
    Rows m_lows, m_highs;
    std::vector<std::uint32_t> m_overlaps;  // 1 or 0
    std::vector<std::uint32_t> m_overlapping;
};

}  // namespace rubble
