#include "core/fracture/HilbertOrder.h"

#include "core/geometry/Polygon.h"

#include <algorithm>
#include <array>
#include <bit>

namespace rubble {

namespace {

constexpr int kBitsAtOnce = 2;         // of x and of y that one table step takes
constexpr std::size_t kSmallRun = 32;  // sorted by comparison below this
constexpr int kMostBits = 16;          // of x and of y in a key

/// The Hilbert curve as a machine: in a state, a quadrant (2 * xBit + yBit) has a place along the curve and a state
/// for what is inside it. States: 0 as drawn (up first), 1 mirrored at the diagonal, 2 at both, 3 at the other one.
struct Quadrant {
    std::uint8_t place;
    std::uint8_t state;
};
constexpr Quadrant kQuadrants[4][4] = {
    {{0, 1}, {1, 0}, {3, 3}, {2, 0}},
    {{0, 0}, {3, 2}, {1, 1}, {2, 1}},
    {{2, 2}, {3, 1}, {1, 2}, {0, 3}},
    {{2, 3}, {1, 3}, {3, 0}, {0, 2}},
};

/// kQuadrants taken kBitsAtOnce times: 4 bits of place and the next state for 2 + 2 bits of position.
struct Step {
    std::uint8_t place;
    std::uint8_t state;
};
constexpr std::array<std::array<Step, 16>, 4> makeSteps() {
    std::array<std::array<Step, 16>, 4> steps{};
    for (int state = 0; state < 4; ++state) {
        for (int bits = 0; bits < 16; ++bits) {
            const int x = bits >> 2, y = bits & 3;
            const Quadrant outer = kQuadrants[state][2 * (x >> 1) + (y >> 1)];
            const Quadrant inner = kQuadrants[outer.state][2 * (x & 1) + (y & 1)];
            steps[state][bits] = {static_cast<std::uint8_t>(4 * outer.place + inner.place), inner.state};
        }
    }
    return steps;
}
constexpr std::array<std::array<Step, 16>, 4> kSteps = makeSteps();

std::uint32_t hilbertKey(std::uint32_t x, std::uint32_t y, int bits) {
    std::uint32_t key = 0;
    std::uint32_t state = 0;
    for (int shift = bits - kBitsAtOnce; shift >= 0; shift -= kBitsAtOnce) {
        const Step step = kSteps[state][((x >> shift) & 3) << 2 | ((y >> shift) & 3)];
        key = key << 4 | step.place;
        state = step.state;
    }
    return key;
}

/// Enough bits for some sixteen cells a point, so that few points share a cell.
int keyBits(std::size_t count) {
    const int bits = (static_cast<int>(std::bit_width(count)) + 1) / 2 + 2;
    return std::min((bits + 1) / kBitsAtOnce * kBitsAtOnce, kMostBits);
}

/// A key above, an index below.
using Keyed = std::uint64_t;

void sortByKey(std::vector<Keyed>& entries, int keyWidth) {
    std::vector<Keyed> other(entries.size());
    for (int shift = 32; shift < 32 + keyWidth; shift += 8) {
        std::array<std::uint32_t, 257> starts{};
        for (const Keyed entry : entries) ++starts[((entry >> shift) & 255) + 1];
        for (int i = 1; i < 257; ++i) starts[i] += starts[i - 1];
        for (const Keyed entry : entries) other[starts[(entry >> shift) & 255]++] = entry;
        entries.swap(other);
    }
}

void sortAlongCurve(std::span<const Vec2> points, std::span<std::uint32_t> order);

/// Orders points of one cell: few by their coordinates, many by a curve of their own.
void sortRun(std::span<const Vec2> points, std::span<std::uint32_t> run) {
    const Vec2 first = points[run.front()];
    const bool allEqual = std::all_of(run.begin(), run.end(), [&](std::uint32_t i) { return points[i] == first; });
    if (allEqual) {
        std::sort(run.begin(), run.end());
    } else if (run.size() > kSmallRun) {
        sortAlongCurve(points, run);
    } else {
        std::sort(run.begin(), run.end(), [&](std::uint32_t a, std::uint32_t b) {
            if (points[a].x != points[b].x) return points[a].x < points[b].x;
            if (points[a].y != points[b].y) return points[a].y < points[b].y;
            return a < b;
        });
    }
}

void sortAlongCurve(std::span<const Vec2> points, std::span<std::uint32_t> order) {
    Box2 box;
    for (const std::uint32_t index : order) box.include(points[index]);
    const int bits = keyBits(order.size());
    const double cells = static_cast<double>(1u << bits);
    const Vec2 size = box.size();
    const double longest = std::max(size.x, size.y);
    const double scale = longest > 0.0 ? cells / longest : 0.0;
    const auto cellOf = [&](double offset) {
        const double cell = offset * scale;
        return cell >= cells ? static_cast<std::uint32_t>(cells) - 1 : static_cast<std::uint32_t>(cell);
    };

    std::vector<Keyed> entries;
    entries.reserve(order.size());
    for (const std::uint32_t index : order) {
        const Vec2 offset = points[index] - box.min;
        const std::uint32_t key = hilbertKey(cellOf(offset.x), cellOf(offset.y), bits);
        entries.push_back(Keyed{key} << 32 | index);
    }
    sortByKey(entries, 2 * bits);

    for (std::size_t i = 0; i < entries.size(); ++i) order[i] = static_cast<std::uint32_t>(entries[i]);
    for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
        for (end = begin + 1; end < entries.size() && entries[end] >> 32 == entries[begin] >> 32;) ++end;
        if (end - begin > 1) sortRun(points, order.subspan(begin, end - begin));
    }
}

}  // namespace

std::vector<std::uint32_t> hilbertOrder(std::span<const Vec2> points) {
    std::vector<std::uint32_t> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
    if (!order.empty()) sortAlongCurve(points, order);
    return order;
}

}  // namespace rubble
