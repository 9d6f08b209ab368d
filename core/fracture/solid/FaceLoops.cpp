#include "core/fracture/solid/FaceLoops.h"

#include "core/base/Assert.h"
#include "core/fracture/solid/SolidPoints.h"
#include "core/geometry/predicates/Predicates.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>

namespace rubble {
namespace {

/// Whether direction a comes before b, going clockwise from `start`.
bool isBeforeClockwise(Vec2 origin, Vec2 start, Vec2 a, Vec2 b) {
    // 1: within half a turn clockwise of `start`; 2: opposite or beyond; 3: along it.
    const auto half = [&](Vec2 p) {
        const int side = orient2d(origin, start, p);
        if (side != 0) return side < 0 ? 1 : 2;
        return glm::dot(start - origin, p - origin) > 0.0 ? 3 : 2;
    };
    const int halfA = half(a), halfB = half(b);
    if (halfA != halfB) return halfA < halfB;
    return orient2d(origin, a, b) < 0;
}

void cancelOpposites(std::vector<PointStep>& edges) {
    const auto key = [](const PointStep& e) { return std::pair(std::min(e.from, e.to), std::max(e.from, e.to)); };
    std::sort(edges.begin(), edges.end(), [&](const PointStep& a, const PointStep& b) {
        return key(a) != key(b) ? key(a) < key(b) : a.from < b.from;
    });
    std::size_t kept = 0;
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        int balance = 0;  // how often more from the lower end than from the higher
        const auto edge = key(edges[begin]);
        for (; end < edges.size() && key(edges[end]) == edge; ++end) balance += edges[end].from == edge.first ? 1 : -1;
        const PointStep step = balance > 0 ? PointStep{edge.first, edge.second} : PointStep{edge.second, edge.first};
        for (int k = 0; k < std::abs(balance); ++k) edges[kept++] = step;
    }
    edges.resize(kept);
}

/// The loop of edges that form one, each point of which is left once, from its lowest point; else empty. O(n²).
PointLoop singleLoop(std::span<const PointStep> edges) {
    constexpr std::size_t kMaxEdges = 64;
    if (edges.size() < 3 || edges.size() > kMaxEdges) return {};
    PointLoop loop = {std::ranges::min(edges, {}, &PointStep::from).from};
    while (true) {
        const auto leaves = [&](const PointStep& edge) { return edge.from == loop.back(); };
        const auto next = std::find_if(edges.begin(), edges.end(), leaves);
        if (next == edges.end() || std::find_if(next + 1, edges.end(), leaves) != edges.end()) return {};
        if (next->to == loop.front()) break;
        if (loop.size() == edges.size()) return {};
        loop.push_back(next->to);
    }
    return loop.size() == edges.size() ? loop : PointLoop();
}

}  // namespace

bool EdgeSplits::add(std::uint32_t from, std::uint32_t to, std::uint32_t point, std::span<const Vec3> points) {
    const auto [low, high] = std::minmax(from, to);
    PointLoop& path = m_points[{low, high}];
    if (std::find(path.begin(), path.end(), point) != path.end()) return false;
    const auto apart = [&](std::uint32_t a, std::uint32_t b) { return glm::length(points[a] - points[b]); };
    const auto next = std::find_if(path.begin(), path.end(), [&, first = low](std::uint32_t other) {
        return apart(other, first) > apart(point, first);
    });
    // Parts are shorter than their edge, so that parts that are divided themselves come to an end.
    const double length = apart(low, high);
    const std::uint32_t before = next == path.begin() ? low : *(next - 1), after = next == path.end() ? high : *next;
    if (apart(before, point) >= length || apart(point, after) >= length) return false;
    path.insert(next, point);
    return true;
}

void EdgeSplits::appendPath(std::uint32_t from, std::uint32_t to, PointLoop& path) const {
    const auto found = m_points.find(std::minmax(from, to));
    if (found == m_points.end() || found->second.empty()) return path.push_back(to);
    std::uint32_t last = from;
    const auto append = [&](std::uint32_t point) {
        appendPath(last, point, path);
        last = point;
    };
    if (from < to)
        std::for_each(found->second.begin(), found->second.end(), append);
    else
        std::for_each(found->second.rbegin(), found->second.rend(), append);
    appendPath(last, to, path);
}

bool isOnEdge(Vec3 point, Vec3 from, Vec3 to, double tolerance) {
    const Vec3 low = glm::min(from, to) - tolerance, high = glm::max(from, to) + tolerance;
    if (glm::any(glm::lessThan(point, low)) || glm::any(glm::greaterThan(point, high))) return false;
    const Vec3 along = to - from, offset = point - from;
    const double length = glm::length(along), place = glm::dot(offset, along) / length;
    if (place <= tolerance || place >= length - tolerance) return false;
    return glm::length(glm::cross(offset, along)) <= tolerance * length;
}

bool isThin(std::span<const std::uint32_t> loop, std::span<const Vec3> points) {
    const Vec3 start = points[loop[0]];
    Vec3 doubleArea(0.0), sides(0.0);  // of sides: the sum of their extents
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec3 a = points[loop[k]], b = points[loop[k + 1 < loop.size() ? k + 1 : 0]];
        doubleArea += glm::cross(a - start, b - start);
        sides += glm::abs(b - a);
    }
    // Nearly all loops are much wider, which needs no roots.
    const Vec3 area = glm::abs(doubleArea);
    if (std::max({area.x, area.y, area.z}) > 2.0 * kSolidWeldDistance * (sides.x + sides.y + sides.z)) return false;
    double length = 0.0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        length += glm::length(points[loop[k + 1 < loop.size() ? k + 1 : 0]] - points[loop[k]]);
    }
    return glm::length(doubleArea) <= kSolidWeldDistance * length;
}

std::vector<PointLoop> simpleLoops(const PointLoop& loop) {
    std::vector<PointLoop> loops;
    PointLoop open;
    for (const std::uint32_t point : loop) {
        const auto before = std::find(open.begin(), open.end(), point);
        if (before != open.end()) {
            if (open.end() - before > 2) loops.emplace_back(before, open.end());
            open.erase(before, open.end());
        }
        open.push_back(point);
    }
    if (open.size() > 2) loops.push_back(std::move(open));
    return loops;
}

std::vector<PointLoop> linkedLoops(std::vector<PointStep> edges, std::span<const Vec3> points, const PlaneView& view) {
    std::vector<PointLoop> loops;
    if (PointLoop loop = singleLoop(edges); !loop.empty()) {
        loops.push_back(std::move(loop));
        return loops;
    }
    cancelOpposites(edges);
    std::sort(edges.begin(), edges.end(),
              [](const PointStep& a, const PointStep& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; });
    std::vector<bool> isUsed(edges.size());
    const auto next = [&](const PointStep& before) {
        auto it = std::lower_bound(edges.begin(), edges.end(), before.to,
                                   [](const PointStep& edge, std::uint32_t from) { return edge.from < from; });
        const Vec2 origin = view(points[before.to]), start = view(points[before.from]);
        std::size_t best = edges.size();
        for (; it != edges.end() && it->from == before.to; ++it) {
            const std::size_t k = static_cast<std::size_t>(it - edges.begin());
            if (isUsed[k]) continue;
            if (best == edges.size() ||
                isBeforeClockwise(origin, start, view(points[it->to]), view(points[edges[best].to]))) {
                best = k;
            }
        }
        return best;
    };
    for (std::size_t first = 0; first < edges.size(); ++first) {
        if (isUsed[first]) continue;
        PointLoop loop;
        for (std::size_t k = first; k != edges.size() && !isUsed[k]; k = next(edges[k])) {
            isUsed[k] = true;
            loop.push_back(edges[k].from);
        }
        for (PointLoop& simple : simpleLoops(loop)) loops.push_back(std::move(simple));
    }
    return loops;
}

}  // namespace rubble
