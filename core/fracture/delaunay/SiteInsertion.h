#pragma once

#include "core/base/TaskContext.h"
#include "core/base/UninitializedVector.h"
#include "core/fracture/delaunay/Delaunay.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rubble {

/// Consecutive sites. A thread that inserts sites of a range changes only triangles whose three corners are in that
/// range, so that several ranges can be processed in parallel.
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

/// Free indices of triangles: [begin, end).
struct FreeSlots {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
};

/// A site on the lifting paraboloid, relative to the centre of all sites.
struct LiftedSite {
    double x = 0.0, y = 0.0, square = 0.0;
};

/// The lifted plane of a triangle, through its lifted corners: sites below it are inside the circumcircle. A ghost
/// triangle's plane is vertical on the hull edge.
struct LiftedPlane {
    double square, x, y, constant;

    /// The scaled depth of the site below the plane: positive inside the circle. Its sign is certain above
    /// inCircleBound.
    double depth(const LiftedSite& site) const { return (x * site.x + y * site.y) + (square * site.square + constant); }
};

/// The triangulation under construction, shared by all insertions.
struct Triangulation {
    /// The first `done` triangles are set already.
    Triangulation(Delaunay& delaunay, std::uint32_t done);

    LiftedSite lifted(Vec2 site) const {
        const double x = site.x - centre.x, y = site.y - centre.y;
        return {x, y, x * x + y * y};
    }

    const Vec2* sites;
    const std::uint32_t* seedOf;
    Delaunay::Triangle* triangles;            // 2n - 2, those in free slots unset
    UninitializedVector<LiftedPlane> planes;  // of the triangles
    Vec2 centre;                              // of the sites' bounding box
    double orientBound;                       // determinants above these have the right sign, for any of the sites
    double inCircleBound;
    double ghostSquare;  // the ghost's lifted coordinate, relative to any site
};

/// Sites to be inserted, and the slots of their triangles.
struct InsertionWork {
    std::vector<std::uint32_t> sites;  // each near the previous one
    std::vector<FreeSlots> free;       // two per site
};

/// Inserts the sites one after the other. The search starts at triangle `start`, which is not a ghost. Stops early if
/// cancelled.
/// Source: Bowyer 1981; Watson 1981.
void insertSites(Triangulation& triangulation, std::uint32_t start, InsertionWork& work, const CancelToken& cancel);

/// The same, without the sites whose insertion would change a triangle that the range does not own: these, and the
/// unused slots, are left in `work`. The range owns `start`.
void insertSites(Triangulation& triangulation, SiteRange range, std::uint32_t start, InsertionWork& work,
                 const CancelToken& cancel);

}  // namespace rubble
