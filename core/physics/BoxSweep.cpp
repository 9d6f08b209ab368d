#include "core/physics/BoxSweep.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <numeric>

namespace rubble {
namespace {

constexpr std::size_t kSideBySide = 8;

/// Whole numbers in the order of floats that are numbers.
std::uint32_t ordered(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value + 0.0f);  // of the two zeros, the positive one
    return (bits >> 31) != 0 ? ~bits : bits | 1u << 31;
}

/// Sorts by the upper 32 bits, equals left in order, a byte at a time: without a comparison that cannot be foreseen.
void sortByUpperHalf(std::vector<std::uint64_t>& values, std::vector<std::uint64_t>& scratch) {
    scratch.resize(values.size());
    for (int shift = 32; shift < 64; shift += 8) {
        std::array<std::uint32_t, 257> begin{};
        const auto byteOf = [&](std::uint64_t value) { return static_cast<std::size_t>(value >> shift & 0xffu); };
        for (const std::uint64_t value : values) ++begin[byteOf(value) + 1];
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        for (const std::uint64_t value : values) scratch[begin[byteOf(value)]++] = value;
        values.swap(scratch);
    }
}

}  // namespace

/// The axis along which middles vary most.
int BoxSweep::mostSpreadAxis() const {
    Vec3f mean(0.0f), squares(0.0f);
    const float share = 1.0f / static_cast<float>(m_boxes.size());
    for (const NumberedBox& one : m_boxes) mean = mean + one.box.middle() * share;
    for (const NumberedBox& one : m_boxes) {
        const Vec3f off = one.box.middle() - mean;
        squares = squares + Vec3f(off.x * off.x, off.y * off.y, off.z * off.z) * share;
    }
    if (squares.x >= squares.y && squares.x >= squares.z) return 0;
    return squares.y >= squares.z ? 1 : 2;
}

void BoxSweep::sort() {
    const std::size_t count = m_boxes.size();
    const int along = count == 0 ? 0 : mostSpreadAxis(), across = (along + 1) % 3, upwards = (along + 2) % 3;
    m_order.clear();
    for (std::size_t i = 0; i < count; ++i) {
        m_order.push_back(static_cast<std::uint64_t>(ordered(m_boxes[i].box.low[along])) << 32 | i);
    }
    sortByUpperHalf(m_order, m_sorted);
    constexpr float kNowhere = std::numeric_limits<float>::infinity();
    m_numbers.resize(count);
    for (Extents* extents : {&m_along, &m_across, &m_upwards}) {
        extents->low.assign(count + kSideBySide, kNowhere);
        extents->high.assign(count + kSideBySide, -kNowhere);
    }
    for (std::size_t place = 0; place < count; ++place) {
        const auto& [box, number] = m_boxes[m_order[place] & 0xffffffffu];
        m_numbers[place] = number;
        m_along.low[place] = box.low[along];
        m_along.high[place] = box.high[along];
        m_across.low[place] = box.low[across];
        m_across.high[place] = box.high[across];
        m_upwards.low[place] = box.low[upwards];
        m_upwards.high[place] = box.high[upwards];
    }
}

std::span<const std::uint32_t> BoxSweep::overlappingLater(std::size_t place, Scratch& scratch) const {
    const float end = m_along.high[place];
    const float left = m_across.low[place], right = m_across.high[place];
    const float bottom = m_upwards.low[place], top = m_upwards.high[place];
    const std::size_t size = m_boxes.size();
    if (scratch.overlapping.size() < size + kSideBySide) scratch.overlapping.resize(size + kSideBySide);
    std::uint32_t* const overlapping = scratch.overlapping.data();
    std::size_t found = 0;
    for (std::size_t begin = place + 1; begin < size && m_along.low[begin] <= end; begin += kSideBySide) {
        const float *along = &m_along.low[begin], *lefts = &m_across.low[begin], *rights = &m_across.high[begin];
        const float *bottoms = &m_upwards.low[begin], *tops = &m_upwards.high[begin];
        std::array<std::uint32_t, kSideBySide> overlaps;
        for (std::size_t i = 0; i < kSideBySide; ++i) {
            const int isBeside = (along[i] <= end) & (lefts[i] <= right) & (left <= rights[i]);
            overlaps[i] = static_cast<std::uint32_t>(isBeside & (bottoms[i] <= top) & (bottom <= tops[i]));
        }
        for (std::size_t i = 0; i < kSideBySide; ++i) {
            // Written in any case, and kept by counting: which boxes overlap cannot be foreseen.
            overlapping[found] = static_cast<std::uint32_t>(begin + i);
            found += overlaps[i];
        }
    }
    for (std::size_t i = 0; i < found; ++i) overlapping[i] = m_numbers[overlapping[i]];
    return {overlapping, found};
}

}  // namespace rubble
