#include "core/fracture/delaunay/SiteInsertion.h"

#include "core/base/UninitializedVector.h"
#include "core/geometry/polygon/Polygon.h"
#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <array>

namespace rubble {
namespace {

constexpr std::uint32_t kScratch = 64;
constexpr std::uint32_t kInsertionsBetweenCancelChecks = 4096;

/// The corners after and before corner k of a triangle: computed, which is faster than a table.
constexpr std::uint32_t after(std::uint32_t k) { return 0b001001u >> 2 * k & 3; }
constexpr std::uint32_t before(std::uint32_t k) { return 0b010010u >> 2 * k & 3; }

/// The range of all sites, and infinity.
struct AllSites {
    static constexpr bool owns(std::uint32_t) { return true; }
};

/// The offset of a corner from another one, lifted.
struct LiftedOffset {
    double x, y, square;
};

/// The offset of a corner from p. That of the ghost is (0, 0, ghostSquare).
LiftedOffset offsetFrom(const Triangulation& in, std::uint32_t corner, Vec2 p) {
    const Vec2 at = corner == kGhost ? p : in.sites[corner];
    const double x = at.x - p.x, y = at.y - p.y;
    return {x, y, (x * x + y * y) + (corner == kGhost ? in.ghostSquare : 0.0)};
}

/// The plane of the triangle (a, b, site); a and b are relative to the site.
LiftedPlane planeThrough(const LiftedOffset& a, const LiftedOffset& b, const LiftedSite& site) {
    const double doubledArea = a.x * b.y - a.y * b.x, twice = doubledArea + doubledArea;
    const double x = a.square * b.y - b.square * a.y, y = b.square * a.x - a.square * b.x;
    return {-doubledArea, x + twice * site.x, y + twice * site.y,
            -((x * site.x + y * site.y) + doubledArea * site.square)};
}

/// Of the triangle (a, b, p), positive if it is counter-clockwise; rounded.
double doubledArea(Vec2 a, Vec2 b, Vec2 p) { return (a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x); }

/// An edge of the cavity, named by its outer half-edge.
struct ReachedEdge {
    std::uint32_t outer;
    std::uint32_t inConflict;  // whether the triangle behind it belongs to the cavity
};

/// Storage of the cavity's lists, interleaved; each has its own count.
struct CavityEntry {
    ReachedEdge reached;  // a stack
    std::uint32_t slot;   // of a triangle in conflict
    std::uint32_t outer;  // the outer half-edge of a boundary edge
};

/// The lengths of the cavity's lists.
struct CavitySize {
    std::uint32_t triangles = 1;
    std::uint32_t edges = 0;
    bool leavesRange = false;  // whether the range does not own a triangle in conflict; then the rest is not valid
};

/// Inserts one site after the other: finds a triangle whose circle contains the site, removes all such triangles (the
/// cavity), and connects the cavity's boundary to the site.
///
/// Glossary. Ghost triangle: (b, a, infinity) behind the hull edge a -> b; its "circle" is the open half-plane behind
/// the edge, and the open edge itself. In conflict: a triangle whose circle contains the new site. The cavity has no
/// vertex inside, so its triangles form a tree and each is reached once, without marks.
template <class Range>
class Inserter {
public:
    Inserter(Triangulation& triangulation, Range range, std::uint32_t start, std::vector<FreeSlots>& free)
        : m_in(triangulation), m_range(range), m_last(start), m_free(free) {}

    /// Inserts a site; false, with nothing changed, if the range does not own a triangle in conflict.
    bool insert(std::uint32_t site) {
        m_site = site;
        m_point = m_in.sites[site];
        m_lifted = m_in.lifted(m_point);
        const std::uint32_t triangle = triangleInConflict();
        if (triangle == kNone) return false;
        const CavitySize cavity = openCavity(triangle);
        if (cavity.leavesRange) return false;
        fillCavity(cavity);
        return true;
    }

private:
    /// Walks from the last triangle towards the site until one is in conflict; kNone if the range does not own it.
    std::uint32_t triangleInConflict() const {
        std::uint32_t triangle = m_last;
        if (isInConflict(triangle)) return triangle;
        const std::uint32_t* corner = m_in.triangles[triangle].corner;
        std::uint32_t exit = isRightOf(corner[0], corner[1], m_point) ? 0 : exitBeside(triangle, 0);
        for (;;) {
            const std::uint32_t entry = m_in.triangles[triangle].twin[exit];
            triangle = entry >> 2;
            if (!m_range.owns(m_in.triangles[triangle].corner[before(entry & 3)])) return kNone;
            if (isInConflict(triangle)) return triangle;
            exit = exitBeside(triangle, entry & 3);
        }
    }

    /// The edge of the triangle, other than `entered`, that has the site on its outer side; the site is not in its
    /// circle.
    std::uint32_t exitBeside(std::uint32_t triangle, std::uint32_t entered) const {
        const std::uint32_t* corner = m_in.triangles[triangle].corner;
        const std::uint32_t left = after(entered), right = before(entered);
        return isRightOf(corner[left], corner[right], m_point) ? left : right;
    }

    bool isRightOf(std::uint32_t a, std::uint32_t b, Vec2 p) const {
        const Vec2 start = m_in.sites[a], end = m_in.sites[b];
        const double determinant = doubledArea(start, end, p);
        if (determinant > m_in.orientBound) return false;
        if (determinant < -m_in.orientBound) return true;
        return orient2d(start, end, p) < 0;
    }

    /// Collects the slots of all triangles in conflict and the cavity's boundary, counter-clockwise; stops where the
    /// cavity leaves the range.
    ///
    /// The stack returns edges counter-clockwise: an edge is boundary, or is replaced by the two behind it. These two
    /// are tested together, because their determinants are independent.
    CavitySize openCavity(std::uint32_t first) {
        CavitySize cavity;
        m_cavity[0].slot = first;
        const Delaunay::Triangle& triangle = m_in.triangles[first];
        ReachedEdge edge = edgeReached(triangle.twin[0]);
        m_cavity[1].reached = edgeReached(triangle.twin[1]);
        m_cavity[0].reached = edgeReached(triangle.twin[2]);
        std::uint32_t waiting = 2;  // on the stack
        for (;;) {
            while (edge.inConflict) {
                const Delaunay::Triangle& opened = m_in.triangles[edge.outer >> 2];
                const std::uint32_t left = after(edge.outer & 3), right = before(edge.outer & 3);
                if (!m_range.owns(opened.corner[right])) {
                    cavity.leavesRange = true;
                    return cavity;
                }
                if (cavity.triangles + 4 >= m_cavity.size()) growScratch();
                m_cavity[cavity.triangles++].slot = edge.outer >> 2;
                m_cavity[waiting++].reached = edgeReached(opened.twin[right]);
                edge = edgeReached(opened.twin[left]);
            }
            m_cavity[cavity.edges++].outer = edge.outer;
            if (waiting == 0) return cavity;
            edge = m_cavity[--waiting].reached;
        }
    }

    [[gnu::noinline]] void growScratch() { m_cavity.resize(2 * m_cavity.size()); }

    /// The edge with the state of the triangle behind it. A range reaches a triangle through two corners that it owns,
    /// so it owns the triangle if it owns the third; meanwhile no other thread changes a triangle that it does not own,
    /// except the twin of this edge.
    ReachedEdge edgeReached(std::uint32_t outer) const { return {outer, isInConflict(outer >> 2)}; }

    [[gnu::always_inline]] bool isInConflict(std::uint32_t triangle) const {
        const double depth = m_in.planes[triangle].depth(m_lifted);
        return std::abs(depth) > m_in.inCircleBound ? depth > 0.0 : isInConflictExactly(triangle);
    }

    [[gnu::noinline]] bool isInConflictExactly(std::uint32_t triangle) const {
        const Vec2 p = m_point;
        const std::array<std::uint32_t, 3> corners = std::to_array(m_in.triangles[triangle].corner);
        for (int k = 0; k < 3; ++k) {
            if (corners[k] == kGhost) return isBehindHull(corners[after(k)], corners[before(k)], p);
        }
        const int sign = inCircle(m_in.sites[corners[0]], m_in.sites[corners[1]], m_in.sites[corners[2]], p);
        return sign != 0 ? sign > 0 : tieIsConflict(corners);
    }

    /// Four cocircular sites: the one of lowest index is infinitesimally lower when lifted, so all diagonals start at
    /// it. If that is the new site, it is inside; if it is a corner, the new site is inside if it lies beyond the
    /// opposite edge.
    bool tieIsConflict(std::array<std::uint32_t, 3> corners) const {
        const auto lowest = std::min_element(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) {
            return m_in.seedOf[a] < m_in.seedOf[b];
        });
        if (m_in.seedOf[m_site] < m_in.seedOf[*lowest]) return true;
        std::rotate(corners.begin(), lowest, corners.end());
        return isRightOf(corners[1], corners[2], m_point);
    }

    /// The ghost triangle (a, b, infinity): the site lies left of a -> b, or on the open edge.
    bool isBehindHull(std::uint32_t a, std::uint32_t b, Vec2 p) const {
        const Vec2 start = m_in.sites[a], end = m_in.sites[b];
        const double determinant = doubledArea(start, end, p);
        if (std::abs(determinant) > m_in.orientBound) return determinant > 0.0;
        const int side = orient2d(start, end, p);
        if (side != 0) return side > 0;
        const bool alongX = start.x != end.x;
        const double from = alongX ? start.x : start.y, to = alongX ? end.x : end.y, at = alongX ? p.x : p.y;
        return (from < at && at < to) || (to < at && at < from);
    }

    void acquireSlots(std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end; ++i) {
            while (m_free[m_nextFree].begin == m_free[m_nextFree].end) ++m_nextFree;
            m_cavity[i].slot = m_free[m_nextFree].begin++;
        }
    }

    /// Connects the cavity's boundary to the site, in the cavity's slots and two more.
    void fillCavity(CavitySize cavity) {
        const std::uint32_t count = cavity.edges;
        acquireSlots(cavity.triangles, count);
        // The first entry again behind the last, so that the loop needs no test for the end.
        m_cavity[count].slot = m_cavity[0].slot;
        m_cavity[count].outer = m_cavity[0].outer;
        std::uint32_t previous = m_cavity[count - 1].slot, from = endOf(m_cavity[0].outer);
        LiftedOffset start = offsetFrom(m_in, from, m_point);
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t slot = m_cavity[i].slot, following = m_cavity[i + 1].slot, outer = m_cavity[i].outer;
            const std::uint32_t to = endOf(m_cavity[i + 1].outer);
            const LiftedOffset end = offsetFrom(m_in, to, m_point);
            m_in.planes[slot] = planeThrough(start, end, m_lifted);
            Delaunay::Triangle& triangle = m_in.triangles[slot];
            triangle.corner[0] = from;
            triangle.corner[1] = to;
            triangle.corner[2] = m_site;
            triangle.twin[0] = outer;
            triangle.twin[1] = 4 * following + 2;
            triangle.twin[2] = 4 * previous + 1;
            m_in.triangles[outer >> 2].twin[outer & 3] = 4 * slot;
            if (from != kGhost && to != kGhost) m_last = slot;
            previous = slot;
            from = to;
            start = end;
        }
    }

    /// The corner at the end of a half-edge.
    std::uint32_t endOf(std::uint32_t halfEdge) const {
        return m_in.triangles[halfEdge >> 2].corner[after(halfEdge & 3)];
    }

    Triangulation& m_in;
    Range m_range;
    std::uint32_t m_last;  // a triangle without ghost corner near the last site
    std::vector<FreeSlots>& m_free;
    std::size_t m_nextFree = 0;  // in m_free

    // The site being inserted.
    std::uint32_t m_site = 0;
    Vec2 m_point{0.0, 0.0};
    LiftedSite m_lifted;

    UninitializedVector<CavityEntry> m_cavity = UninitializedVector<CavityEntry>(kScratch);
};

template <class Range>
void insertAll(Triangulation& triangulation, Range range, std::uint32_t start, InsertionWork& work,
               const CancelToken& cancel) {
    Inserter<Range> inserter(triangulation, range, start, work.free);
    std::size_t left = 0;
    for (std::size_t i = 0; i < work.sites.size(); ++i) {
        if (i % kInsertionsBetweenCancelChecks == 0 && cancel.isCancelled()) break;
        if (!inserter.insert(work.sites[i])) work.sites[left++] = work.sites[i];
    }
    work.sites.resize(left);
}

}  // namespace

Triangulation::Triangulation(Delaunay& delaunay, std::uint32_t done)
    : sites(delaunay.sites.data()),
      seedOf(delaunay.seedOf.data()),
      triangles(delaunay.triangles.data()),
      planes(delaunay.triangles.size()) {
    const Box2 box = boundsOf(delaunay.sites);
    centre = 0.5 * (box.min + box.max);
    // All sites lie within half of this from the centre, which is rounded.
    const Vec2 size = 2.0 * (1.0 + 4.0 * kRounding) * glm::max(box.max - centre, centre - box.min);
    const double product = size.x * size.y, squares = size.x * size.x + size.y * size.y;
    orientBound = 2.0 * kOrientBound * product;
    // Forward error in units of kRounding * product * squares: 3 of the square's term, 16 of x's and of y's, 25.25 of
    // the constant, 11 of the sums. Of a ghost triangle 12 in units of kRounding * product * ghostSquare.
    inCircleBound = 72.0 * kRounding * product * squares;
    ghostSquare = 5.0 * squares;
    for (std::uint32_t t = 0; t < done; ++t) {
        std::array<std::uint32_t, 3> corner = std::to_array(triangles[t].corner);
        while (corner[2] == kGhost) std::rotate(corner.begin(), corner.begin() + 1, corner.end());
        const Vec2 p = sites[corner[2]];
        planes[t] = planeThrough(offsetFrom(*this, corner[0], p), offsetFrom(*this, corner[1], p), lifted(p));
    }
}

void insertSites(Triangulation& triangulation, std::uint32_t start, InsertionWork& work, const CancelToken& cancel) {
    insertAll(triangulation, AllSites(), start, work, cancel);
}

void insertSites(Triangulation& triangulation, SiteRange range, std::uint32_t start, InsertionWork& work,
                 const CancelToken& cancel) {
    insertAll(triangulation, range, start, work, cancel);
}

}  // namespace rubble
