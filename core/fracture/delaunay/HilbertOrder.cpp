#include "core/fracture/delaunay/HilbertOrder.h"

#include "core/base/Parallel.h"
#include "core/base/RadixSort.h"
#include "core/geometry/polygon/Polygon.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace rubble {
namespace {

constexpr int kBitsPerStep = 2;                // of x and of y that one table look-up consumes
constexpr std::size_t kMaxSmallRun = 32;       // larger runs get a curve of their own
constexpr int kMaxBits = 16;                   // of x and of y in a key
constexpr std::size_t kMinForThreads = 32768;  // points; fewer do not repay the additional passes

/// The Hilbert curve as a state machine: in each state, a quadrant (2 * xBit + yBit) has a position along the curve and
/// a state for its inside. States: 0 upright (up first), 1 mirrored at the diagonal, 2 at both diagonals, 3 at the
/// other.
struct Quadrant {
    std::uint8_t position;
    std::uint8_t state;
};
constexpr Quadrant kQuadrants[4][4] = {
    {{0, 1}, {1, 0}, {3, 3}, {2, 0}},
    {{0, 0}, {3, 2}, {1, 1}, {2, 1}},
    {{2, 2}, {3, 1}, {1, 2}, {0, 3}},
    {{2, 3}, {1, 3}, {3, 0}, {0, 2}},
};

/// kQuadrants applied kBitsPerStep times: 4 bits of the key and the next state for 2 + 2 bits of x and y.
struct Step {
    std::uint8_t keyBits;
    std::uint8_t state;
};
constexpr std::array<std::array<Step, 16>, 4> makeSteps() {
    std::array<std::array<Step, 16>, 4> steps{};
    for (int state = 0; state < 4; ++state) {
        for (int bits = 0; bits < 16; ++bits) {
            const int x = bits >> 2, y = bits & 3;
            const Quadrant outer = kQuadrants[state][2 * (x >> 1) + (y >> 1)];
            const Quadrant inner = kQuadrants[outer.state][2 * (x & 1) + (y & 1)];
            steps[state][bits] = {static_cast<std::uint8_t>(4 * outer.position + inner.position), inner.state};
        }
    }
    return steps;
}
constexpr std::array<std::array<Step, 16>, 4> kSteps = makeSteps();

std::uint32_t hilbertKey(std::uint32_t x, std::uint32_t y, int bits) {
    std::uint32_t key = 0;
    std::uint32_t state = 0;
    for (int shift = bits - kBitsPerStep; shift >= 0; shift -= kBitsPerStep) {
        const Step step = kSteps[state][((x >> shift) & 3) << 2 | ((y >> shift) & 3)];
        key = key << 4 | step.keyBits;
        state = step.state;
    }
    return key;
}

/// Enough bits for about sixteen cells per point, so that few points share a cell.
int keyBits(std::size_t count) {
    const int bits = (static_cast<int>(std::bit_width(count)) + 1) / 2 + 2;
    return std::min((bits + 1) / kBitsPerStep * kBitsPerStep, kMaxBits);
}

constexpr std::size_t kDigits = std::size_t{1} << kMaxDigitBits;
std::size_t digitOf(KeyedIndex entry, int shift) { return (entry >> shift) & (kDigits - 1); }

/// A square grid of cells along the curve.
class HilbertGrid {
public:
    HilbertGrid(const Box2& box, std::size_t count)
        : m_min(box.min), m_bits(keyBits(count)), m_cells(static_cast<double>(1u << m_bits)) {
        const Vec2 size = box.size();
        const double longest = std::max(size.x, size.y);
        m_scale = longest > 0.0 ? m_cells / longest : 0.0;
    }
    int keyWidth() const { return 2 * m_bits; }
    KeyedIndex entryOf(Vec2 point, std::uint32_t index) const {
        const Vec2 offset = point - m_min;
        return keyedIndex(hilbertKey(cellOf(offset.x), cellOf(offset.y), m_bits), index);
    }

private:
    std::uint32_t cellOf(double offset) const {
        const double cell = offset * m_scale;
        return cell >= m_cells ? static_cast<std::uint32_t>(m_cells) - 1 : static_cast<std::uint32_t>(cell);
    }

    Vec2 m_min;
    int m_bits;
    double m_cells;
    double m_scale = 0.0;
};

void sortAlongCurve(std::span<const Vec2> points, std::span<std::uint32_t> order);

/// Sorts the points of one cell: few by their coordinates, many along a curve of their own.
void sortRun(std::span<const Vec2> points, std::span<std::uint32_t> run) {
    const Vec2 first = points[run.front()];
    const bool allEqual = std::all_of(run.begin(), run.end(), [&](std::uint32_t i) { return points[i] == first; });
    if (allEqual) {
        std::sort(run.begin(), run.end());
    } else if (run.size() > kMaxSmallRun) {
        sortAlongCurve(points, run);
    } else {
        std::sort(run.begin(), run.end(), [&](std::uint32_t a, std::uint32_t b) {
            if (points[a].x != points[b].x) return points[a].x < points[b].x;
            if (points[a].y != points[b].y) return points[a].y < points[b].y;
            return a < b;
        });
    }
}

/// Writes the indices of sorted entries and sorts those of equal keys.
void writeSorted(std::span<const KeyedIndex> entries, std::span<const Vec2> points, std::span<std::uint32_t> order) {
    for (std::size_t i = 0; i < entries.size(); ++i) order[i] = indexOf(entries[i]);
    for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
        for (end = begin + 1; end < entries.size() && keyOf(entries[end]) == keyOf(entries[begin]);) ++end;
        if (end - begin > 1) sortRun(points, order.subspan(begin, end - begin));
    }
}

void sortAlongCurve(std::span<const Vec2> points, std::span<std::uint32_t> order) {
    Box2 box;
    for (const std::uint32_t index : order) box.include(points[index]);
    const HilbertGrid grid(box, order.size());
    UninitializedVector<KeyedIndex> entries(order.size()), other(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) entries[i] = grid.entryOf(points[order[i]], order[i]);
    writeSorted(radixSortByKey(entries, other, grid.keyWidth()), points, order);
}

/// Sorts many points on several threads: into buckets by the highest digit, then each bucket.
class ParallelSort {
public:
    ParallelSort(std::span<const Vec2> points, std::span<std::uint32_t> order, int threads)
        : m_points(points),
          m_order(order),
          m_threads(threads),
          m_grid(boundsOf(points), points.size()),
          m_topShift(32 + std::max(m_grid.keyWidth() - kMaxDigitBits, 0)),
          m_entries(points.size()),
          m_buckets(points.size()) {}

    void run() {
        forEachIndex(kParts, m_threads, [this](std::size_t part) { makeKeys(part); });
        findBucketStarts();
        forEachIndex(kParts, m_threads, [this](std::size_t part) { moveToBuckets(part); });
        forEachIndex(kDigits, m_threads, [this](std::size_t digit) { sortBucket(digit); });
    }

private:
    static constexpr std::size_t kParts = 16;

    void makeKeys(std::size_t part) {
        const IndexRange range = chunkRange(m_points.size(), part, kParts);
        for (std::size_t i = range.begin; i < range.end; ++i) {
            m_entries[i] = m_grid.entryOf(m_points[i], static_cast<std::uint32_t>(i));
            ++m_positions[part][digitOf(m_entries[i], m_topShift)];
        }
    }

    /// Turns counts into positions: a bucket holds the entries of each part, in the order of the parts.
    void findBucketStarts() {
        std::uint32_t position = 0;
        for (std::size_t digit = 0; digit < kDigits; ++digit) {
            m_bucketStarts[digit] = position;
            for (std::array<std::uint32_t, kDigits>& positions : m_positions) {
                position += std::exchange(positions[digit], position);
            }
        }
        m_bucketStarts[kDigits] = position;
    }

    void moveToBuckets(std::size_t part) {
        const IndexRange range = chunkRange(m_points.size(), part, kParts);
        for (std::size_t i = range.begin; i < range.end; ++i) {
            m_buckets[m_positions[part][digitOf(m_entries[i], m_topShift)]++] = m_entries[i];
        }
    }

    void sortBucket(std::size_t digit) {
        const std::size_t begin = m_bucketStarts[digit], size = m_bucketStarts[digit + 1] - begin;
        const std::span<KeyedIndex> sorted = radixSortByKey(std::span(m_buckets).subspan(begin, size),
                                                            std::span(m_entries).subspan(begin, size), m_topShift - 32);
        writeSorted(sorted, m_points, m_order.subspan(begin, size));
    }

    std::span<const Vec2> m_points;
    std::span<std::uint32_t> m_order;
    int m_threads;
    HilbertGrid m_grid;
    int m_topShift;  // of the highest digit
    UninitializedVector<KeyedIndex> m_entries;
    UninitializedVector<KeyedIndex> m_buckets;
    std::array<std::array<std::uint32_t, kDigits>, kParts> m_positions{};
    std::array<std::uint32_t, kDigits + 1> m_bucketStarts{};
};

}  // namespace

UninitializedVector<std::uint32_t> hilbertOrder(std::span<const Vec2> points, int threads) {
    UninitializedVector<std::uint32_t> order(points.size());
    if (points.size() >= kMinForThreads) {
        ParallelSort(points, order, threads).run();
    } else if (!points.empty()) {
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
        sortAlongCurve(points, order);
    }
    return order;
}

}  // namespace rubble
