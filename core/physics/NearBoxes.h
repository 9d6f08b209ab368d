#pragma once

#include "core/physics/BoxTree.h"

namespace rubble {

/// Boxes of a tree, to be tried by several others that lie close together: side by side, so that many are tried at once.
class NearBoxes {
public:
    /// Those that overlap a box.
    void gather(const BoxTree& tree, const Box& around);

    /// Calls visit(number) for each that overlaps, in the order of BoxTree::visitOverlapping().
    template <class Visit>
    void visitOverlapping(const Box& box, const Visit& visit) {
        tryAll(box);
        for (std::size_t i = 0; i < m_count; ++i) {
            if (m_overlaps[i] != 0) visit(m_numbers[i]);
        }
    }

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
    std::vector<std::uint32_t> m_overlaps;
};

}  // namespace rubble
