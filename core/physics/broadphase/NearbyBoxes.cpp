#include "core/physics/broadphase/NearbyBoxes.h"

#include <algorithm>

namespace rubble {

void NearbyBoxes::Rows::resize(std::size_t size) {
    x.resize(size);
    y.resize(size);
    z.resize(size);
}

void NearbyBoxes::gather(const DynamicBoxTree& tree, const Box& around) {
    m_count = 0;
    tree.visitOverlapping(around, [&](std::uint32_t number, const Box& box) { add(number, box); });
}

void NearbyBoxes::add(std::uint32_t number, const Box& box) {
    if (m_count == m_numbers.size()) {
        const std::size_t size = std::max<std::size_t>(64, 2 * m_count);
        m_numbers.resize(size);
        m_overlaps.resize(size);
        m_overlapping.resize(size);
        m_lows.resize(size);
        m_highs.resize(size);
    }
    m_numbers[m_count] = number;
    m_lows.x[m_count] = box.low.x;
    m_lows.y[m_count] = box.low.y;
    m_lows.z[m_count] = box.low.z;
    m_highs.x[m_count] = box.high.x;
    m_highs.y[m_count] = box.high.y;
    m_highs.z[m_count] = box.high.z;
    ++m_count;
}

std::span<const std::uint32_t> NearbyBoxes::overlapping(const Box& box) {
    testAll(box);
    std::size_t count = 0;
    for (std::size_t i = 0; i < m_count; ++i) {
        // Branchless: written unconditionally, kept by counting, since overlap is unpredictable.
        m_overlapping[count] = m_numbers[i];
        count += m_overlaps[i];
    }
    return {m_overlapping.data(), count};
}

void NearbyBoxes::testAll(const Box& box) {
    const float *lowX = m_lows.x.data(), *lowY = m_lows.y.data(), *lowZ = m_lows.z.data();
    const float *highX = m_highs.x.data(), *highY = m_highs.y.data(), *highZ = m_highs.z.data();
    std::uint32_t* overlaps = m_overlaps.data();
    for (std::size_t i = 0; i < m_count; ++i) {
        const int below = (lowX[i] <= box.high.x) & (lowY[i] <= box.high.y) & (lowZ[i] <= box.high.z);
        const int above = (box.low.x <= highX[i]) & (box.low.y <= highY[i]) & (box.low.z <= highZ[i]);
        overlaps[i] = static_cast<std::uint32_t>(below & above);
    }
}

}  // namespace rubble
