#include "core/physics/broadphase/SortAndSweep.h"

#include "core/base/Assert.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace rubble {
namespace {

constexpr std::size_t kBatch = 8;

/// An integer with the order of floats other than NaN.
std::uint32_t orderedBits(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value + 0.0f);  // makes -0 positive
    return (bits >> 31) != 0 ? ~bits : bits | 1u << 31;
}

}  // namespace

int SortAndSweep::axisOfGreatestVariance() const {
    Vec3f mean(0.0f), squares(0.0f);
    const float weight = 1.0f / static_cast<float>(m_boxes.size());
    for (const NumberedBox& one : m_boxes) mean = mean + one.box.middle() * weight;
    for (const NumberedBox& one : m_boxes) {
        const Vec3f offset = one.box.middle() - mean;
        squares = squares + Vec3f(offset.x * offset.x, offset.y * offset.y, offset.z * offset.z) * weight;
    }
    if (squares.x >= squares.y && squares.x >= squares.z) return 0;
    return squares.y >= squares.z ? 1 : 2;
}

void SortAndSweep::sort() {
    const std::size_t count = m_boxes.size();
    const int along = m_axis = count == 0 ? 0 : axisOfGreatestVariance();
    const int across = (along + 1) % 3, upwards = (along + 2) % 3;
    m_order.clear();
    for (std::size_t i = 0; i < count; ++i) {
        m_order.push_back(keyedIndex(orderedBits(m_boxes[i].box.low[along]), static_cast<std::uint32_t>(i)));
    }
    m_scratch.resize(count);
    const std::span<const KeyedIndex> order = radixSortByKey(m_order, m_scratch, 32);
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    m_numbers.resize(count);
    for (Extents* extents : {&m_along, &m_across, &m_upwards}) {
        extents->low.assign(count + kBatch, kInfinity);
        extents->high.assign(count + kBatch, -kInfinity);
    }
    for (std::size_t rank = 0; rank < count; ++rank) {
        const auto& [box, number] = m_boxes[indexOf(order[rank])];
        m_numbers[rank] = number;
        m_along.low[rank] = box.low[along];
        m_along.high[rank] = box.high[along];
        m_across.low[rank] = box.low[across];
        m_across.high[rank] = box.high[across];
        m_upwards.low[rank] = box.low[upwards];
        m_upwards.high[rank] = box.high[upwards];
    }
}

std::span<const std::uint32_t> SortAndSweep::overlappingLater(std::size_t rank, Scratch& scratch) const {
    RUBBLE_ASSERT(rank < size() && m_numbers.size() == size());  // sorted since the last box was added
    Box box;
    box.low[m_axis] = m_along.low[rank];
    box.high[m_axis] = m_along.high[rank];
    box.low[(m_axis + 1) % 3] = m_across.low[rank];
    box.high[(m_axis + 1) % 3] = m_across.high[rank];
    box.low[(m_axis + 2) % 3] = m_upwards.low[rank];
    box.high[(m_axis + 2) % 3] = m_upwards.high[rank];
    return overlappingFrom(rank + 1, box, scratch);
}

std::span<const std::uint32_t> SortAndSweep::overlapping(const Box& box, Scratch& scratch) const {
    RUBBLE_ASSERT(m_numbers.size() == size());
    return overlappingFrom(0, box, scratch);
}

/// Of the boxes from a rank on.
std::span<const std::uint32_t> SortAndSweep::overlappingFrom(std::size_t first, const Box& box,
                                                             Scratch& scratch) const {
    const int across = (m_axis + 1) % 3, upwards = (m_axis + 2) % 3;
    const float begin = box.low[m_axis], end = box.high[m_axis];
    const float left = box.low[across], right = box.high[across];
    const float bottom = box.low[upwards], top = box.high[upwards];
    const std::size_t size = m_boxes.size();
    if (scratch.overlapping.size() < size + kBatch) scratch.overlapping.resize(size + kBatch);
    std::uint32_t* const overlapping = scratch.overlapping.data();
    std::size_t found = 0;
    for (std::size_t rank = first; rank < size && m_along.low[rank] <= end; rank += kBatch) {
        const float *lows = &m_along.low[rank], *highs = &m_along.high[rank];
        const float *lefts = &m_across.low[rank], *rights = &m_across.high[rank];
        const float *bottoms = &m_upwards.low[rank], *tops = &m_upwards.high[rank];
        std::array<std::uint32_t, kBatch> overlaps;
        for (std::size_t i = 0; i < kBatch; ++i) {
            const int isBeside = (lows[i] <= end) & (begin <= highs[i]) & (lefts[i] <= right) & (left <= rights[i]);
            overlaps[i] = static_cast<std::uint32_t>(isBeside & (bottoms[i] <= top) & (bottom <= tops[i]));
        }
        for (std::size_t i = 0; i < kBatch; ++i) {
            // Branchless: written unconditionally, kept by counting, since overlap is unpredictable.
            overlapping[found] = static_cast<std::uint32_t>(rank + i);
            found += overlaps[i];
        }
    }
    for (std::size_t i = 0; i < found; ++i) overlapping[i] = m_numbers[overlapping[i]];
    return {overlapping, found};
}

}  // namespace rubble
