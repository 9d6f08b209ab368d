#pragma once

#include "core/base/RawVector.h"
#include "core/base/TaskContext.h"
#include "core/fracture/Delaunay.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rubble {

/// Sites with consecutive insertion numbers. Whoever inserts sites of a range may change the triangles between three
/// sites of that range and no others, so that several ranges can be worked on at the same time.
class SiteRange {
public:
    SiteRange(std::uint32_t first, std::uint32_t last) : m_first(first), m_span(last - first) {}

    bool owns(std::uint32_t corner) const { return corner - m_first <= m_span; }
    bool owns(const Delaunay::Triangle& triangle) const {
        return owns(triangle.corner[0]) && owns(triangle.corner[1]) && owns(triangle.corner[2]);
    }

private:
    std::uint32_t m_first, m_span;
};

/// Free places for triangles: [begin, end).
struct FreeSlots {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
};

/// A site relative to the middle of all, with its square: a point of the paraboloid.
struct LiftedSite {
    double x = 0.0, y = 0.0, square = 0.0;
};

/// What tells sites inside a triangle's circle from those outside: the plane through its lifted corners. A ghost
/// triangle's stands upright on the hull's edge.
struct CirclePlane {
    double square, x, y, constant;

    /// How far the site is below the plane, scaled: positive inside the circle. In doubt up to inCircleBound.
    double depth(const LiftedSite& site) const { return (x * site.x + y * site.y) + (square * site.square + constant); }
};

/// What is common to all insertions into one triangulation.
struct Triangulation {
    /// Of these sites; the first `done` triangles are there already.
    Triangulation(Delaunay& delaunay, std::uint32_t done);

    LiftedSite lifted(Vec2 site) const {
        const double x = site.x - middle.x, y = site.y - middle.y;
        return {x, y, x * x + y * y};
    }

    const Vec2* sites;
    const std::uint32_t* seedOf;
    Delaunay::Triangle* triangles;  // 2n - 2, those in free slots unset
    RawVector<CirclePlane> planes;  // of the triangles
    Vec2 middle;                    // of the sites' bounds
    double orientBound;             // determinants above these have the right sign, whichever sites they are of
    double inCircleBound;
    double ghostSquare;  // the ghost's, as a corner at the site that sees it
};

/// Sites that are to be inserted, and where their triangles go.
struct InsertionWork {
    std::vector<std::uint32_t> sites;  // each near the one before it
    std::vector<FreeSlots> free;       // two a site
};

/// Inserts the sites one after the other. Begins to look at triangle `start`, which is no ghost. Stops early where it is
/// cancelled.
/// Source: Bowyer 1981; Watson 1981.
void insertSites(Triangulation& triangulation, std::uint32_t start, InsertionWork& work, const CancelToken& cancel);

/// The same, but for those sites whose insertion would change a triangle that is not the range's own: these, and the slots
/// that were not needed, are left in `work`. The range owns `start`.
void insertSites(Triangulation& triangulation, SiteRange range, std::uint32_t start, InsertionWork& work,
                 const CancelToken& cancel);

}  // namespace rubble
