#pragma once

#include "core/physics/broadphase/DynamicBoxTree.h"

namespace rubble {

/// The boxes of a tree near a group of query boxes that lie close together, stored as a structure of arrays, so that
/// each query tests many boxes at once.
class NearbyBoxes {
public:
    /// Collects the tree's boxes that overlap `around`.
    void gather(const DynamicBoxTree& tree, const Box& around);

    /// The numbers of the collected boxes that overlap `box`, in the order of DynamicBoxTree::visitOverlapping(); valid
    /// until the next call.
    std::span<const std::uint32_t> overlapping(const Box& box);

    std::size_t size() const { return m_count; }

private:
    struct Rows {
        std::vector<float> x, y, z;
        void resize(std::size_t size);
    };

    void add(std::uint32_t number, const Box& box);
    void testAll(const Box& box);

    std::size_t m_count = 0;
    std::vector<std::uint32_t> m_numbers;  // this and the rows below are longer than m_count
    Rows m_lows, m_highs;
    std::vector<std::uint32_t> m_overlaps;  // 1 or 0
    std::vector<std::uint32_t> m_overlapping;
};

}  // namespace rubble
