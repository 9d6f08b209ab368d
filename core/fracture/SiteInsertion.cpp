#include "core/fracture/SiteInsertion.h"

#include "core/base/RawVector.h"
#include "core/geometry/Polygon.h"
#include "core/geometry/Predicates.h"

#include <algorithm>
#include <array>

namespace rubble {

namespace {

constexpr std::uint32_t kGhost = Delaunay::kGhost;
constexpr std::uint32_t kScratch = 64;
constexpr std::uint32_t kNowhere = 0xffffffffu;
constexpr std::uint32_t kNoExit = 3;
constexpr std::uint32_t kInsertionsBetweenCancelChecks = 4096;

/// The corners after and before corner k of a triangle, computed because a table's load takes longer.
constexpr std::uint32_t after(std::uint32_t k) { return 0b001001u >> 2 * k & 3; }
constexpr std::uint32_t before(std::uint32_t k) { return 0b010010u >> 2 * k & 3; }

/// The range of all sites, and infinity.
struct AllSites {
    static constexpr bool owns(std::uint32_t) { return true; }
};

/// A corner as the new site sees it: its offset from the site, and that offset's square.
struct Lifted {
    double x, y, square;
    std::uint32_t corner;
};
double cross(const Lifted& a, const Lifted& b) { return a.x * b.y - a.y * b.x; }

/// Of the triangle (a, b, p), positive where it is counter-clockwise. Rounded.
double doubledArea(Vec2 a, Vec2 b, Vec2 p) { return (a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x); }

/// An edge of the cavity, which lies on its left, and what lies behind it. Corners are named by their place in m_lifted.
struct ReachedEdge {
    std::uint32_t from, to;
    std::uint32_t outer;  // the half-edge behind it, which runs towards `from`
    std::uint32_t apex;   // the third corner of the triangle behind it
    bool inConflict;      // whether that triangle belongs to the cavity too

    /// Copies field by field: a copy in wide loads would wait for narrow stores that have just been made.
    void take(const ReachedEdge& other) {
        from = other.from;
        to = other.to;
        outer = other.outer;
        apex = other.apex;
        inConflict = other.inConflict;
    }
};

struct BoundaryEdge {
    std::uint32_t from;   // corner
    std::uint32_t outer;  // the half-edge outside, which runs towards `from`
};

/// How much of m_slots and m_boundary is of the cavity.
struct CavitySize {
    std::uint32_t triangles = 1;
    std::uint32_t edges = 0;
    bool leavesRange = false;  // whether a triangle in conflict is not the range's; then the rest is not known
};

/// Inserts one site after the other: finds the triangle that holds the site, takes away all triangles whose circle holds
/// it (the cavity), and joins the cavity's boundary to it.
///
/// Glossary. Ghost triangle: (b, a, infinity) behind the hull edge a -> b; its "circle" is the open half-plane behind
/// the edge, and the open edge itself. Conflict: a triangle whose circle holds the new site. The cavity has no vertex
/// inside, so its triangles form a tree and every one is reached once, without marks.
template <class Range>
class Inserter {
public:
    Inserter(const Triangulation& triangulation, Range range, std::uint32_t start, std::vector<FreeSlots>& free)
        : m_in(triangulation), m_range(range), m_last(start), m_free(free) {}

    /// Inserts a site; false, with nothing changed, where a triangle in conflict is not the range's.
    bool insert(std::uint32_t site) {
        const std::uint32_t triangle = triangleHolding(site);
        if (triangle == kNowhere) return false;
        const CavitySize cavity = openCavity(site, triangle);
        if (cavity.leavesRange) return false;
        fillCavity(site, cavity);
        return true;
    }

private:
    /// Walks from the last triangle towards the site; the result is in conflict with it, and the range's own.
    std::uint32_t triangleHolding(std::uint32_t site) const {
        const Vec2 p = m_in.sites[site];
        std::uint32_t triangle = m_last;
        const std::uint32_t* corner = m_in.triangles[triangle].corner;
        std::uint32_t leaveBy = isRightOf(corner[0], corner[1], p) ? 0 : exitBeside(triangle, 0, p);
        while (leaveBy != kNoExit) {
            const std::uint32_t across = m_in.triangles[triangle].twin[leaveBy];
            triangle = across >> 2;
            const std::uint32_t apex = m_in.triangles[triangle].corner[before(across & 3)];
            if (!m_range.owns(apex)) return kNowhere;
            if (apex == kGhost) return triangle;
            leaveBy = exitBeside(triangle, across & 3, p);
        }
        return triangle;
    }

    /// Which of the triangle's edges other than `entered` has the point on its outer side. Both are tested at once and
    /// chosen from without a branch: which one it is cannot be predicted.
    std::uint32_t exitBeside(std::uint32_t triangle, std::uint32_t entered, Vec2 p) const {
        const std::uint32_t* corner = m_in.triangles[triangle].corner;
        const std::uint32_t left = after(entered), right = before(entered);
        const Vec2 apex = m_in.sites[corner[right]];
        const double toLeft = doubledArea(m_in.sites[corner[left]], apex, p);
        const double toRight = doubledArea(apex, m_in.sites[corner[entered]], p);
        if (std::min(std::abs(toLeft), std::abs(toRight)) <= m_in.orientBound) {
            if (isRightOf(corner[left], corner[right], p)) return left;
            return isRightOf(corner[right], corner[entered], p) ? right : kNoExit;
        }
        const std::uint32_t leftOrRight = toLeft < 0.0 ? left : right;
        return std::min(toLeft, toRight) < 0.0 ? leftOrRight : kNoExit;
    }

    bool isRightOf(std::uint32_t a, std::uint32_t b, Vec2 p) const {
        const Vec2 start = m_in.sites[a], end = m_in.sites[b];
        const double determinant = doubledArea(start, end, p);
        if (determinant > m_in.orientBound) return false;
        if (determinant < -m_in.orientBound) return true;
        return orient2d(start, end, p) < 0;
    }

    /// Collects the slots of all triangles in conflict and the cavity's boundary, counter-clockwise; stops where the cavity
    /// leaves the range.
    ///
    /// The stack gives reached edges back counter-clockwise: an edge is boundary, or gives way to the two behind it. Those
    /// are tested together, because their determinants do not wait for each other.
    CavitySize openCavity(std::uint32_t site, std::uint32_t first) {
        const Vec2 p = m_in.sites[site];
        CavitySize cavity;
        m_slots[0] = first;
        const Delaunay::Triangle& triangle = m_in.triangles[first];
        for (std::uint32_t k = 0; k < 3; ++k) lift(triangle.corner[k], p, m_lifted[k]);
        ReachedEdge edge = edgeReached(site, p, triangle.twin[0], 0, 1, 3);
        m_reached[1].take(edgeReached(site, p, triangle.twin[1], 1, 2, 4));
        m_reached[0].take(edgeReached(site, p, triangle.twin[2], 2, 0, 5));
        std::uint32_t waiting = 2;  // in m_reached
        std::uint32_t places = 6;   // in m_lifted
        for (;;) {
            while (edge.inConflict) {
                if (!m_range.owns(m_lifted[edge.apex].corner)) {
                    cavity.leavesRange = true;
                    return cavity;
                }
                if (places + 2 >= m_capacity) growScratch();
                m_slots[cavity.triangles++] = edge.outer >> 2;
                const Delaunay::Triangle& opened = m_in.triangles[edge.outer >> 2];
                const std::uint32_t toApex = opened.twin[after(edge.outer & 3)];
                const std::uint32_t fromApex = opened.twin[before(edge.outer & 3)];
                m_reached[waiting++].take(edgeReached(site, p, fromApex, edge.apex, edge.to, places++));
                edge.take(edgeReached(site, p, toApex, edge.from, edge.apex, places++));
            }
            BoundaryEdge& boundary = m_boundary[cavity.edges++];
            boundary.from = m_lifted[edge.from].corner;
            boundary.outer = edge.outer;
            if (waiting == 0) return cavity;
            edge.take(m_reached[--waiting]);
        }
    }

    /// Every entry of the scratch arrays comes with a lifted corner.
    [[gnu::noinline]] void growScratch() {
        const std::size_t size = m_capacity *= 2;
        m_reached.resize(size);
        m_lifted.resize(size);
        m_slots.resize(size);
        m_boundary.resize(size);
    }

    /// What the site at p sees of a corner. The ghost is at (0, 0, ghostSquare).
    void lift(std::uint32_t corner, Vec2 p, Lifted& lifted) const {
        const Vec2 at = corner == kGhost ? p : m_in.sites[corner];
        const double x = at.x - p.x, y = at.y - p.y;
        lifted.x = x;
        lifted.y = y;
        lifted.square = (x * x + y * y) + (corner == kGhost ? m_in.ghostSquare : 0.0);
        lifted.corner = corner;
    }

    /// What lies behind an edge of the cavity; lifts the corner there to `apex`. The determinant of a ghost triangle is the
    /// orientation of its edge and the site, in the scale of inCircleBound. A range reaches a triangle through two corners
    /// of its own, so that it owns the triangle where it owns the third; one that it does not own stays as it is meanwhile,
    /// but for the twin behind this very edge.
    [[gnu::always_inline]] ReachedEdge edgeReached(std::uint32_t site, Vec2 p, std::uint32_t outer, std::uint32_t from,
                                                   std::uint32_t to, std::uint32_t apex) {
        const Delaunay::Triangle& triangle = m_in.triangles[outer >> 2];
        const Lifted &a = m_lifted[from], &b = m_lifted[to];
        Lifted& c = m_lifted[apex];
        lift(triangle.corner[before(outer & 3)], p, c);
        const double determinant = b.square * cross(a, c) + a.square * cross(c, b) + c.square * cross(b, a);
        const bool isSure = std::abs(determinant) > m_in.inCircleBound;
        return {from, to, outer, apex, isSure ? determinant > 0.0 : isInConflict(site, {b.corner, a.corner, c.corner})};
    }

    /// Whether the circle of the corners holds the site: exactly, for any triangle.
    [[gnu::noinline]] bool isInConflict(std::uint32_t site, std::array<std::uint32_t, 3> corners) const {
        const Vec2 p = m_in.sites[site];
        for (int k = 0; k < 3; ++k) {
            if (corners[k] == kGhost) return isBehindHull(corners[after(k)], corners[before(k)], p);
        }
        const int sign = inCircle(m_in.sites[corners[0]], m_in.sites[corners[1]], m_in.sites[corners[2]], p);
        return sign != 0 ? sign > 0 : tieIsConflict(corners, site);
    }

    /// Four sites on one circle: the one of lowest index is pulled down in the lifted picture, so all diagonals start
    /// at it. If that is the new site, it is inside; if it is a corner, the new site is inside where it lies
    /// beyond the opposite edge.
    bool tieIsConflict(std::array<std::uint32_t, 3> corners, std::uint32_t site) const {
        const auto lowest = std::min_element(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) {
            return m_in.seedOf[a] < m_in.seedOf[b];
        });
        if (m_in.seedOf[site] < m_in.seedOf[*lowest]) return true;
        std::rotate(corners.begin(), lowest, corners.end());
        return isRightOf(corners[1], corners[2], m_in.sites[site]);
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

    void takeSlots(std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end; ++i) {
            while (m_free[m_nextFree].begin == m_free[m_nextFree].end) ++m_nextFree;
            m_slots[i] = m_free[m_nextFree].begin++;
        }
    }

    /// Fans the cavity's boundary out from the site, in the cavity's slots and two more.
    void fillCavity(std::uint32_t site, CavitySize cavity) {
        const std::uint32_t count = cavity.edges;
        takeSlots(cavity.triangles, count);
        // The first again behind the last, so that the loop need not ask for the end.
        m_slots[count] = m_slots[0];
        m_boundary[count].from = m_boundary[0].from;
        std::uint32_t previous = m_slots[count - 1];
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t slot = m_slots[i], following = m_slots[i + 1];
            const std::uint32_t from = m_boundary[i].from, outer = m_boundary[i].outer, to = m_boundary[i + 1].from;
            Delaunay::Triangle& triangle = m_in.triangles[slot];
            triangle.corner[0] = from;
            triangle.corner[1] = to;
            triangle.corner[2] = site;
            triangle.twin[0] = outer;
            triangle.twin[1] = 4 * following + 2;
            triangle.twin[2] = 4 * previous + 1;
            m_in.triangles[outer >> 2].twin[outer & 3] = 4 * slot;
            if (from != kGhost && to != kGhost) m_last = slot;
            previous = slot;
        }
    }

    Triangulation m_in;
    Range m_range;
    std::uint32_t m_last;  // a triangle without ghost near the last site
    std::vector<FreeSlots>& m_free;
    std::size_t m_nextFree = 0;  // in m_free

    // Scratch, all of one size.
    std::uint32_t m_capacity = kScratch;
    RawVector<ReachedEdge> m_reached = RawVector<ReachedEdge>(kScratch);  // a stack
    RawVector<Lifted> m_lifted = RawVector<Lifted>(kScratch);             // corners seen from the new site
    RawVector<std::uint32_t> m_slots = RawVector<std::uint32_t>(kScratch);
    RawVector<BoundaryEdge> m_boundary = RawVector<BoundaryEdge>(kScratch);
};

template <class Range>
void insertAll(const Triangulation& triangulation, Range range, std::uint32_t start, InsertionWork& work,
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

Triangulation::Triangulation(Delaunay& delaunay)
    : sites(delaunay.sites.data()), seedOf(delaunay.seedOf.data()), triangles(delaunay.triangles.data()) {
    // The filters' error bounds for the largest differences that can occur.
    const Vec2 size = boundsOf(delaunay.sites).size() * (1.0 + 4.0 * kRounding);
    const double product = size.x * size.y;
    orientBound = 2.0 * kOrientBound * product;
    inCircleBound = 6.0 * kInCircleBound * product * (size.x * size.x + size.y * size.y);
    ghostSquare = 0.5 * inCircleBound / orientBound;
}

void insertSites(const Triangulation& triangulation, std::uint32_t start, InsertionWork& work,
                 const CancelToken& cancel) {
    insertAll(triangulation, AllSites(), start, work, cancel);
}

void insertSites(const Triangulation& triangulation, SiteRange range, std::uint32_t start, InsertionWork& work,
                 const CancelToken& cancel) {
    insertAll(triangulation, range, start, work, cancel);
}

}  // namespace rubble
