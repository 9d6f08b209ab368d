#include "core/fracture/delaunay/InsertionRounds.h"

#include "core/base/Parallel.h"
#include "core/fracture/delaunay/SiteInsertion.h"
#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <bit>

namespace rubble {
namespace {

constexpr std::uint32_t kMinRangeSites = 16384;   // so many that few are near the border
constexpr std::uint32_t kMinSitesPerRange = 256;  // inserted already, before a round has ranges
constexpr std::uint32_t kMaxRanges = 16;
constexpr std::uint32_t kGrowth = 8;          // of the number of sites from round to round; a power of two
constexpr std::uint32_t kMinFirstRound = 12;  // sites of the first of several rounds
constexpr std::uint32_t kFirstTriangles = 4;

/// The first triangle, of sites 0, 1 and 2, with its three ghosts.
void makeFirstTriangle(Delaunay& delaunay) {
    std::uint32_t b = 1, c = 2;
    if (orient2d(delaunay.sites[0], delaunay.sites[1], delaunay.sites[2]) < 0) std::swap(b, c);
    delaunay.triangles[0] = {{0, b, c}, {4, 8, 12}};
    delaunay.triangles[1] = {{b, 0, kGhost}, {0, 14, 9}};
    delaunay.triangles[2] = {{c, b, kGhost}, {1, 6, 13}};
    delaunay.triangles[3] = {{0, c, kGhost}, {2, 10, 5}};
}

class InsertionRounds {
public:
    InsertionRounds(Delaunay& delaunay, const TaskContext& task)
        : m_delaunay(delaunay),
          m_task(task),
          m_triangulation(delaunay, kFirstTriangles),
          m_count(static_cast<std::uint32_t>(delaunay.sites.size())) {}

    /// Inserts every n-th site along the curve first, then those between them: a site changes fewer triangles of a
    /// coarse triangulation than at the end of a row of sites, and several threads can insert at the same time.
    Status run() {
        std::uint32_t stride = 1;
        while (m_count / stride >= kGrowth * kMinFirstRound) stride *= kGrowth;
        Status inserted = insertRound(stride, 0, 1);
        for (; inserted && stride > 1; stride /= kGrowth)
            inserted = insertRound(stride / kGrowth, stride, rangeCount());
        return inserted;
    }

private:
    /// The number of ranges of the next round: limited so that each has inserted sites away from its borders.
    std::uint32_t rangeCount() const {
        const std::uint32_t max = std::min({m_count / kMinRangeSites, m_inserted / kMinSitesPerRange, kMaxRanges});
        return std::bit_floor(std::max(max, 1u));
    }

    /// Inserts the sites whose numbers are multiples of `stride` but not of `done`, which are inserted already (0: none
    /// are).
    Status insertRound(std::uint32_t stride, std::uint32_t done, std::uint32_t rangeCount) {
        const std::uint32_t triangleCount = 2 * m_inserted - 2;
        m_ranges.assign(rangeCount, {});
        for (std::uint32_t r = 0; r < rangeCount; ++r) assignWork(r, stride, done);
        if (rangeCount > 1) insertRanges(triangleCount);
        insertRemaining();
        m_task.report(static_cast<double>(m_inserted) / m_count);
        return m_task.isCancelled() ? Status(TaskContext::cancelled()) : success();
    }

    void assignWork(std::uint32_t r, std::uint32_t stride, std::uint32_t done) {
        InsertionWork& work = m_ranges[r];
        const IndexRange range = rangeAt(r);
        const std::size_t first = (range.begin + stride - 1) / stride * stride;
        work.sites.reserve(range.size() / stride + 1);
        for (std::size_t site = first; site < range.end; site += stride) {
            if (done == 0 || (site & (done - 1)) != 0) work.sites.push_back(static_cast<std::uint32_t>(site));
        }
        const std::uint32_t begin = 2 * m_inserted - 2;
        m_inserted += static_cast<std::uint32_t>(work.sites.size());
        work.free = {{begin, 2 * m_inserted - 2}};
    }

    /// The sites of a range, without 0 to 2, the corners of the first triangle.
    IndexRange rangeAt(std::size_t r) const {
        IndexRange range = chunkRange(m_count, r, m_ranges.size());
        range.begin = std::max(range.begin, std::size_t{3});
        return range;
    }
    SiteRange sitesAt(std::size_t r) const {
        return {static_cast<std::uint32_t>(rangeAt(r).begin), static_cast<std::uint32_t>(rangeAt(r).end) - 1};
    }

    void insertRanges(std::uint32_t triangleCount) {
        const std::vector<std::uint32_t> starts = ownTriangles(triangleCount);
        forEachIndex(m_ranges.size(), m_task.threads, [&](std::size_t r) {
            if (starts[r] != kNone) insertSites(m_triangulation, sitesAt(r), starts[r], m_ranges[r], m_task.cancel);
        });
    }

    /// For each range one of the first triangles whose corners are all in it; kNone if there is none yet.
    std::vector<std::uint32_t> ownTriangles(std::uint32_t triangleCount) const {
        std::vector<std::uint32_t> found(m_ranges.size(), kNone);
        for (std::uint32_t t = 0; t < triangleCount; ++t) {
            const Delaunay::Triangle& triangle = m_delaunay.triangles[t];
            if (triangle.corner[0] == kGhost) continue;
            const std::size_t r = triangle.corner[0] * m_ranges.size() / m_count;  // or, rarely, the next one
            if (found[r] == kNone && sitesAt(r).owns(triangle)) found[r] = t;
        }
        return found;
    }

    void insertRemaining() {
        InsertionWork all = std::move(m_ranges[0]);
        for (std::size_t r = 1; r < m_ranges.size(); ++r) {
            all.sites.insert(all.sites.end(), m_ranges[r].sites.begin(), m_ranges[r].sites.end());
            all.free.insert(all.free.end(), m_ranges[r].free.begin(), m_ranges[r].free.end());
        }
        std::uint32_t start = 0;
        while (m_delaunay.triangles[start].isGhost()) ++start;
        insertSites(m_triangulation, start, all, m_task.cancel);
    }

    Delaunay& m_delaunay;
    const TaskContext& m_task;
    Triangulation m_triangulation;
    std::uint32_t m_count;
    std::uint32_t m_inserted = 3;
    std::vector<InsertionWork> m_ranges;  // of this round, in the sites' order
};

}  // namespace

Status insertSites(Delaunay& delaunay, const TaskContext& task) {
    delaunay.triangles.resize(2 * delaunay.sites.size() - 2);
    makeFirstTriangle(delaunay);
    return InsertionRounds(delaunay, task).run();
}

}  // namespace rubble
