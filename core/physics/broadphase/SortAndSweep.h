#pragma once

#include "core/base/RadixSort.h"
#include "core/physics/math/Box.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Finds all overlapping pairs of many boxes: the boxes are sorted along the axis of greatest variance, and each is
/// tested against those that begin before it ends, several at once. Faster than a tree where most boxes are new, since
/// the tree would be built for one query.
/// Source: Baraff 1992 (sort and sweep); Ericson 2005, 7.5.
class SortAndSweep {
public:
    /// Memory of one thread; several may query at once.
    struct Scratch {
        std::vector<std::uint32_t> overlapping;
    };

    void clear() { m_boxes.clear(); }
    /// Adds a box under the caller's number, which must be unique.
    void add(std::uint32_t number, const Box& box) { m_boxes.push_back({box, number}); }
    /// Sorts the added boxes, which assigns each a rank, starting at 0.
    void sort();

    std::size_t size() const { return m_boxes.size(); }
    std::uint32_t number(std::size_t rank) const { return m_numbers[rank]; }
    /// After sort(): the numbers of the boxes that overlap the box at `rank` and have a higher rank, by ascending rank:
    /// each pair is found once. Valid until the scratch is used again.
    std::span<const std::uint32_t> overlappingLater(std::size_t rank, Scratch& scratch) const;
    /// After sort(): the numbers of the boxes that overlap any box, by ascending rank. Valid until the scratch is used
    /// again.
    std::span<const std::uint32_t> overlapping(const Box& box, Scratch& scratch) const;

private:
    struct NumberedBox {
        Box box;
        std::uint32_t number;
    };
    /// The bounds of all boxes by rank, padded with empty boxes.
    struct Extents {
        std::vector<float> low, high;
    };

    int axisOfGreatestVariance() const;
    std::span<const std::uint32_t> overlappingFrom(std::size_t begin, const Box& box, Scratch& scratch) const;

    std::vector<NumberedBox> m_boxes;
    std::vector<KeyedIndex> m_order, m_scratch;  // low end and index of each box
    std::vector<std::uint32_t> m_numbers;
    int m_axis = 0;                        // along which the boxes are sorted
    Extents m_along, m_across, m_upwards;  // the sweep axis, and the other two
};

}  // namespace rubble
