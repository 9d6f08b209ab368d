#include "core/fracture/solid/HilbertCurve3.h"

#include "core/geometry/search/Box3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rubble {
namespace {

constexpr int kBits = 16;  // of a coordinate: a cell of the curve holds few points but for clusters

/// The position along the curve of a cell with coordinates of kBits bits.
std::uint64_t positionOf(std::array<std::uint32_t, 3> cell) {
    for (std::uint32_t bit = 1u << (kBits - 1); bit > 1; bit >>= 1) {
        const std::uint32_t below = bit - 1;
        for (std::uint32_t& coordinate : cell) {
            if (coordinate & bit) {
                cell[0] ^= below;
            } else {
                const std::uint32_t swapped = (cell[0] ^ coordinate) & below;
                cell[0] ^= swapped;
                coordinate ^= swapped;
            }
        }
    }
    cell[1] ^= cell[0];
    cell[2] ^= cell[1];
    std::uint32_t flips = 0;
    for (std::uint32_t bit = 1u << (kBits - 1); bit > 1; bit >>= 1) {
        if (cell[2] & bit) flips ^= bit - 1;
    }
    std::uint64_t position = 0;
    for (int bit = kBits - 1; bit >= 0; --bit) {
        for (const std::uint32_t coordinate : cell) position = position << 1 | (((coordinate ^ flips) >> bit) & 1);
    }
    return position;
}

struct Entry {
    std::uint64_t position;
    std::uint32_t index;
};

}  // namespace

UninitializedVector<std::uint32_t> hilbertOrder(std::span<const Vec3> points) {
    Box3 box;
    for (const Vec3 point : points) box.include(point);
    const Vec3 size = box.max - box.min;
    const double longest = std::max({size.x, size.y, size.z});
    const double scale = longest > 0.0 ? (std::exp2(kBits) - 1.0) / longest : 0.0;
    std::vector<Entry> entries(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const Vec3 offset = (points[i] - box.min) * scale;
        entries[i] = {positionOf({static_cast<std::uint32_t>(offset.x), static_cast<std::uint32_t>(offset.y),
                                  static_cast<std::uint32_t>(offset.z)}),
                      i};
    }
    std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
        if (a.position != b.position) return a.position < b.position;
        if (points[a.index] != points[b.index]) return lexicographicLess(points[a.index], points[b.index]);
        return a.index < b.index;
    });
    UninitializedVector<std::uint32_t> order(points.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = entries[k].index;
    return order;
}

}  // namespace rubble
