#pragma once

#include "core/physics/Box.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Finds which of many boxes overlap, without a tree: sorted along the axis on which they lie most spread, each is tried against
/// those that begin before it ends, several side by side. For a moment in which most boxes are new, and a tree would have to be built
/// to be asked once.
/// Source: Baraff 1992 (sort and sweep); Ericson 2005, 7.5.
class BoxSweep {
public:
    /// What one caller needs to ask; several may ask at the same time.
    struct Scratch {
        std::vector<std::uint32_t> overlapping;
    };

    void clear() { m_boxes.clear(); }
    /// Adds a box under the caller's number; numbers differ.
    void add(std::uint32_t number, const Box& box) { m_boxes.push_back({box, number}); }
    /// Sorts all boxes that were added, and so gives each a place, from 0.
    void sort();

    std::size_t size() const { return m_boxes.size(); }
    std::uint32_t number(std::size_t place) const { return m_numbers[place]; }
    /// The numbers of those that overlap the box at a place and have a later one, in order of their places: each pair is found
    /// once. Valid until the scratch is used again, for the caller to write in.
    std::span<const std::uint32_t> overlappingLater(std::size_t place, Scratch& scratch) const;

private:
    struct NumberedBox {
        Box box;
        std::uint32_t number;
    };
    /// Rows by place, padded by boxes that overlap nothing.
    struct Extents {
        std::vector<float> low, high;
    };

    int mostSpreadAxis() const;

    std::vector<NumberedBox> m_boxes;
    std::vector<std::uint64_t> m_order, m_sorted;  // where a box begins, and which it is
    std::vector<std::uint32_t> m_numbers;
    Extents m_along, m_across, m_upwards;  // the axis of the sweep, and the two others
};

}  // namespace rubble
