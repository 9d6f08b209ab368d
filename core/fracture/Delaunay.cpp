#include "core/fracture/Delaunay.h"

#include "core/fracture/HilbertOrder.h"
#include "core/geometry/Polygon.h"
#include "core/geometry/Predicates.h"

#include <algorithm>
#include <string>

namespace rubble {

namespace {

constexpr std::uint32_t kGhost = Delaunay::kGhost;
constexpr std::uint32_t kNext[3] = {1, 2, 0};
constexpr std::uint32_t kInsertionsBetweenCancelChecks = 4096;

/// Bounds below which no determinant over these sites needs a closer look: the filters' error bounds for the largest
/// differences that can occur.
struct StaticBounds {
    double orient = 0.0;
    double inCircle = 0.0;
};
StaticBounds staticBounds(std::span<const Vec2> sites) {
    const Vec2 size = boundsOf(sites).size() * (1.0 + 4.0 * kRounding);
    const double product = size.x * size.y;
    return {2.0 * kOrientBound * product, 6.0 * kInCircleBound * product * (size.x * size.x + size.y * size.y)};
}

/// A corner as the new site sees it: its offset from the site, and that offset's square.
struct Lifted {
    double x, y, square;
};
double cross(const Lifted& a, const Lifted& b) { return a.x * b.y - a.y * b.x; }

/// An edge of the cavity, which lies on its left. Lifted corners are named by their place in Builder::m_lifted.
struct CavityEdge {
    std::uint32_t from;  // corner
    std::uint32_t fromLifted, toLifted;
};

/// An edge that the cavity has reached, and what lies behind it.
struct ReachedEdge {
    CavityEdge edge;
    std::uint32_t outer;  // the half-edge behind it, which runs towards edge.from
    std::uint32_t apex;   // the third corner of the triangle behind it
    std::uint32_t apexLifted;
    bool inConflict;  // whether that triangle belongs to the cavity too
};

/// Inserts sites one after the other: find the triangle that holds the site, take away all triangles whose circle
/// holds it (the cavity), and join the cavity's boundary to it.
///
/// Glossary. Ghost triangle: (b, a, infinity) behind the hull edge a -> b; its "circle" is the open half-plane behind
/// the edge, and the open edge itself. Conflict: a triangle whose circle holds the new site. The cavity has no vertex
/// inside, so its triangles form a tree and every one is reached once, without marks.
class Builder {
public:
    explicit Builder(Delaunay& delaunay)
        : m_sites(delaunay.sites),
          m_seedOf(delaunay.seedOf),
          m_triangles(delaunay.triangles),
          m_bounds(staticBounds(delaunay.sites)) {
        m_triangles.reserve(2 * m_sites.size());
    }

    /// The first triangle, of sites 0, 1 and 2, with its three ghosts.
    void begin() {
        std::uint32_t b = 1, c = 2;
        if (orient2d(m_sites[0], m_sites[1], m_sites[2]) < 0) std::swap(b, c);
        m_triangles.push_back({{0, b, c}, {4, 8, 12}});
        m_triangles.push_back({{b, 0, kGhost}, {0, 14, 9}});
        m_triangles.push_back({{c, b, kGhost}, {1, 6, 13}});
        m_triangles.push_back({{0, c, kGhost}, {2, 10, 5}});
        m_last = 0;
    }

    void insert(std::uint32_t site) {
        openCavity(site, triangleHolding(site));
        fillCavity(site);
    }

private:
    /// Walks from the last triangle towards the site; the result is in conflict with it.
    std::uint32_t triangleHolding(std::uint32_t site) const {
        const Vec2 p = m_sites[site];
        std::uint32_t triangle = m_last;
        int entered = -1;
        for (;;) {
            const Delaunay::Triangle& here = m_triangles[triangle];
            int leaveBy = -1;
            for (int k = 0; k < 3 && leaveBy < 0; ++k) {
                if (k != entered && isRightOf(here.corner[k], here.corner[k == 2 ? 0 : k + 1], p)) leaveBy = k;
            }
            if (leaveBy < 0) return triangle;
            const std::uint32_t across = here.twin[leaveBy];
            triangle = across >> 2;
            entered = static_cast<int>(across & 3);
            const Delaunay::Triangle& there = m_triangles[triangle];
            if (there.corner[entered == 0 ? 2 : entered - 1] == kGhost) return triangle;
        }
    }

    bool isRightOf(std::uint32_t a, std::uint32_t b, Vec2 p) const {
        const Vec2 start = m_sites[a], end = m_sites[b];
        const double determinant = (start.x - p.x) * (end.y - p.y) - (start.y - p.y) * (end.x - p.x);
        if (determinant > m_bounds.orient) return false;
        if (determinant < -m_bounds.orient) return true;
        return orient2d(start, end, p) < 0;
    }

    /// Collects the slots of all triangles in conflict and the cavity's boundary, counter-clockwise.
    ///
    /// The stack gives reached edges back counter-clockwise: an edge is boundary, or gives way to the two behind it. Those
    /// are tested together, because their determinants do not wait for each other.
    void openCavity(std::uint32_t site, std::uint32_t first) {
        m_boundary.clear();
        m_slots.assign(1, first);
        m_liftedCount = 3;
        const Delaunay::Triangle& triangle = m_triangles[first];
        for (std::uint32_t k = 0; k < 3; ++k) m_lifted[k] = lifted(triangle.corner[k], site);
        for (std::uint32_t k = 0; k < 3; ++k) {
            lookBehind(site, triangle.twin[k], {triangle.corner[k], k, kNext[k]}, m_reached[2 - k]);
        }
        for (std::size_t top = 3; top > 0;) {
            if (m_reached[top - 1].inConflict) {
                growScratch(top);
                openBehind(site, top++);
            } else {
                --top;
                m_boundary.push_back({m_reached[top].edge.from, m_reached[top].outer});
            }
        }
    }

    /// Takes the triangle behind the top edge into the cavity and replaces that edge by the triangle's two others.
    void openBehind(std::uint32_t site, std::size_t top) {
        // Copied field by field: a copy in wide loads would wait for the narrow stores that have just been made.
        const ReachedEdge& reached = m_reached[top - 1];
        const CavityEdge edge = {reached.edge.from, reached.edge.fromLifted, reached.edge.toLifted};
        const std::uint32_t outer = reached.outer, apex = reached.apex, apexLifted = reached.apexLifted;
        const Delaunay::Triangle& behind = m_triangles[outer >> 2];
        m_slots.push_back(outer >> 2);
        const std::uint32_t right = kNext[outer & 3], left = kNext[right];
        lookBehind(site, behind.twin[left], {apex, apexLifted, edge.toLifted}, m_reached[top - 1]);
        lookBehind(site, behind.twin[right], {edge.from, edge.fromLifted, apexLifted}, m_reached[top]);
    }

    void growScratch(std::size_t top) {
        if (top + 1 >= m_reached.size()) m_reached.resize(2 * m_reached.size());
        if (m_liftedCount + 2 >= m_lifted.size()) m_lifted.resize(2 * m_lifted.size());
    }

    Lifted lifted(std::uint32_t corner, std::uint32_t site) const {
        if (corner == kGhost) return {0.0, 0.0, 0.0};
        const double x = m_sites[corner].x - m_sites[site].x, y = m_sites[corner].y - m_sites[site].y;
        return {x, y, x * x + y * y};
    }

    /// Finds out what lies behind an edge of the cavity.
    void lookBehind(std::uint32_t site, std::uint32_t outer, CavityEdge edge, ReachedEdge& reached) {
        const Delaunay::Triangle& triangle = m_triangles[outer >> 2];
        const std::uint32_t to = triangle.corner[outer & 3], apex = triangle.corner[kNext[kNext[outer & 3]]];
        const std::uint32_t apexLifted = m_liftedCount++;
        const Lifted &a = m_lifted[edge.fromLifted], &b = m_lifted[edge.toLifted];
        const Lifted c = m_lifted[apexLifted] = lifted(apex, site);
        const double determinant = b.square * cross(a, c) + a.square * cross(c, b) + c.square * cross(b, a);
        const bool hasGhost = edge.from == kGhost || to == kGhost || apex == kGhost;
        const bool isSure = std::abs(determinant) > m_bounds.inCircle && !hasGhost;
        reached.edge.from = edge.from;
        reached.edge.fromLifted = edge.fromLifted;
        reached.edge.toLifted = edge.toLifted;
        reached.outer = outer;
        reached.apex = apex;
        reached.apexLifted = apexLifted;
        reached.inConflict = isSure ? determinant > 0.0 : isInConflict(site, {to, edge.from, apex});
    }

    /// Whether the circle of the corners holds the site: exactly, for any triangle.
    [[gnu::noinline]] bool isInConflict(std::uint32_t site, std::array<std::uint32_t, 3> corners) const {
        const Vec2 p = m_sites[site];
        for (int k = 0; k < 3; ++k) {
            if (corners[k] == kGhost) return isBehindHull(corners[kNext[k]], corners[kNext[kNext[k]]], p);
        }
        const int sign = inCircle(m_sites[corners[0]], m_sites[corners[1]], m_sites[corners[2]], p);
        return sign != 0 ? sign > 0 : tieIsConflict(corners, site);
    }

    /// Four sites on one circle: the one of lowest index is pulled down in the lifted picture, so all diagonals start
    /// at it. If that is the new site, it is inside; if it is a corner, the new site is inside where it lies
    /// beyond the opposite edge.
    bool tieIsConflict(std::array<std::uint32_t, 3> corners, std::uint32_t site) const {
        const auto lowest = std::min_element(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) {
            return m_seedOf[a] < m_seedOf[b];
        });
        if (m_seedOf[site] < m_seedOf[*lowest]) return true;
        std::rotate(corners.begin(), lowest, corners.end());
        return isRightOf(corners[1], corners[2], m_sites[site]);
    }

    /// The ghost triangle (a, b, infinity): the site lies left of a -> b, or on the open edge.
    bool isBehindHull(std::uint32_t a, std::uint32_t b, Vec2 p) const {
        const Vec2 start = m_sites[a], end = m_sites[b];
        const int side = orient2d(start, end, p);
        if (side != 0) return side > 0;
        const bool alongX = start.x != end.x;
        const double from = alongX ? start.x : start.y, to = alongX ? end.x : end.y, at = alongX ? p.x : p.y;
        return (from < at && at < to) || (to < at && at < from);
    }

    /// Fans the cavity's boundary out from the site, in the cavity's slots and two more.
    void fillCavity(std::uint32_t site) {
        for (std::size_t missing = m_boundary.size() - m_slots.size(); missing > 0; --missing) {
            m_slots.push_back(static_cast<std::uint32_t>(m_triangles.size()));
            m_triangles.emplace_back();
        }
        const std::size_t count = m_boundary.size();
        std::uint32_t previous = m_slots[count - 1];
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t slot = m_slots[i];
            const std::uint32_t following = m_slots[i + 1 < count ? i + 1 : 0];
            const BoundaryEdge& edge = m_boundary[i];
            const std::uint32_t end = m_boundary[i + 1 < count ? i + 1 : 0].from;
            m_triangles[slot] = {{edge.from, end, site}, {edge.outer, 4 * following + 2, 4 * previous + 1}};
            m_triangles[edge.outer >> 2].twin[edge.outer & 3] = 4 * slot;
            if (edge.from != kGhost && end != kGhost) m_last = slot;
            previous = slot;
        }
    }

    struct BoundaryEdge {
        std::uint32_t from;   // corner
        std::uint32_t outer;  // the half-edge outside, which runs towards `from`
    };

    const std::vector<Vec2>& m_sites;
    const std::vector<std::uint32_t>& m_seedOf;
    std::vector<Delaunay::Triangle>& m_triangles;
    StaticBounds m_bounds;
    std::uint32_t m_last = 0;                                           // a triangle without ghost near the last site
    std::vector<ReachedEdge> m_reached = std::vector<ReachedEdge>(64);  // a stack
    std::vector<Lifted> m_lifted = std::vector<Lifted>(64);             // corners seen from the new site
    std::uint32_t m_liftedCount = 0;
    std::vector<std::uint32_t> m_slots;
    std::vector<BoundaryEdge> m_boundary;
};

/// Puts the seeds into Hilbert order and leaves equal ones out.
void takeSites(std::span<const Vec2> seeds, Delaunay& delaunay) {
    const std::vector<std::uint32_t> order = hilbertOrder(seeds);
    delaunay.sites.reserve(seeds.size());
    delaunay.seedOf.reserve(seeds.size());
    for (const std::uint32_t seed : order) {
        if (!delaunay.sites.empty() && delaunay.sites.back() == seeds[seed]) {
            delaunay.duplicates.push_back({seed, delaunay.seedOf.back()});
        } else {
            delaunay.sites.push_back(seeds[seed]);
            delaunay.seedOf.push_back(seed);
        }
    }
    std::sort(delaunay.duplicates.begin(), delaunay.duplicates.end());
}

/// Moves the first site that is not on the line of sites 0 and 1 to place 2; false where there is none.
bool bringOffLineSiteForward(Delaunay& delaunay) {
    const std::vector<Vec2>& sites = delaunay.sites;
    std::size_t third = 2;
    while (third < sites.size() && orient2d(sites[0], sites[1], sites[third]) == 0) ++third;
    if (third >= sites.size()) return false;
    const auto rotate = [third](auto& values) {
        std::rotate(values.begin() + 2, values.begin() + static_cast<std::ptrdiff_t>(third),
                    values.begin() + static_cast<std::ptrdiff_t>(third) + 1);
    };
    rotate(delaunay.sites);
    rotate(delaunay.seedOf);
    return true;
}

/// Joins sites on one line: edge k from site k to k + 1 along the line has the ghosts 2k on its left and 2k + 1 on its right.
void joinAlongLine(Delaunay& delaunay) {
    const std::vector<Vec2>& sites = delaunay.sites;
    std::vector<std::uint32_t> line(sites.size());
    for (std::uint32_t i = 0; i < sites.size(); ++i) line[i] = i;
    std::sort(line.begin(), line.end(), [&](std::uint32_t a, std::uint32_t b) {
        return sites[a].x != sites[b].x ? sites[a].x < sites[b].x : sites[a].y < sites[b].y;
    });
    const std::uint32_t edges = static_cast<std::uint32_t>(line.size()) - 1;
    for (std::uint32_t k = 0; k < edges; ++k) {
        const std::uint32_t left = 4 * (2 * k), right = 4 * (2 * k + 1);
        const bool isFirst = k == 0, isLast = k + 1 == edges;
        delaunay.triangles.push_back({{line[k], line[k + 1], kGhost},
                                      {right, isLast ? right + 2 : left + 8 + 2, isFirst ? right + 1 : left - 8 + 1}});
        delaunay.triangles.push_back({{line[k + 1], line[k], kGhost},
                                      {left, isFirst ? left + 2 : right - 8 + 2, isLast ? left + 1 : right + 8 + 1}});
    }
}

}  // namespace

Result<Delaunay> triangulate(std::span<const Vec2> seeds, const TaskContext& task) {
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        if (isExactlyUsable(seeds[i])) continue;
        return Error{ErrorCode::BadInput, "Seed " + std::to_string(i) + " " + *coordinateFault(seeds[i]) + "."};
    }
    Delaunay delaunay;
    takeSites(seeds, delaunay);
    if (!bringOffLineSiteForward(delaunay)) {
        if (delaunay.sites.size() > 1) joinAlongLine(delaunay);
        return delaunay;
    }
    Builder builder(delaunay);
    builder.begin();
    const std::uint32_t count = static_cast<std::uint32_t>(delaunay.sites.size());
    for (std::uint32_t site = 3; site < count; ++site) {
        if (site % kInsertionsBetweenCancelChecks == 0) {
            if (task.isCancelled()) return TaskContext::cancelled();
            task.report(static_cast<double>(site) / count);
        }
        builder.insert(site);
    }
    return delaunay;
}

std::vector<std::uint32_t> outgoingHalfEdges(const Delaunay& delaunay) {
    std::vector<std::uint32_t> outgoing(delaunay.sites.size());
    for (std::uint32_t t = 0; t < delaunay.triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t corner = delaunay.triangles[t].corner[k];
            if (corner != kGhost) outgoing[corner] = 4 * t + k;
        }
    }
    return outgoing;
}

std::vector<std::array<std::uint32_t, 3>> triangleList(const Delaunay& delaunay) {
    std::vector<std::array<std::uint32_t, 3>> list;
    list.reserve(delaunay.triangles.size());
    for (const Delaunay::Triangle& triangle : delaunay.triangles) {
        const std::uint32_t* corner = triangle.corner;
        if (corner[0] == kGhost || corner[1] == kGhost || corner[2] == kGhost) continue;
        std::array<std::uint32_t, 3> seeds = {delaunay.seedOf[corner[0]], delaunay.seedOf[corner[1]],
                                              delaunay.seedOf[corner[2]]};
        std::rotate(seeds.begin(), std::min_element(seeds.begin(), seeds.end()), seeds.end());
        list.push_back(seeds);
    }
    std::sort(list.begin(), list.end());
    return list;
}

}  // namespace rubble
