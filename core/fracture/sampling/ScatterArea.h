#pragma once

#include "core/base/Random.h"
#include "core/base/Result.h"
#include "core/fracture/sampling/ScatterDomain.h"
#include "core/geometry/polygon/Polygon.h"

#include <array>
#include <vector>

namespace rubble {

/// Uniform random points of a polygon. It is triangulated; each point draws a triangle by area and a point in it: three
/// random numbers, without rejection.
class ScatterArea {
public:
    /// The outline or its bounding box.
    static Polygon domain(const Polygon& outline, ScatterDomain domain);

    /// Errors: those of triangles().
    static Result<ScatterArea> of(const Polygon& polygon);

    Vec2 point(Random& random) const;
    double area() const { return m_areasUpTo.back(); }  // m²

private:
    struct Triangle {
        Vec2 corner;
        Vec2 first;  // from the corner to the next
        Vec2 second;
    };
    std::vector<Triangle> m_triangles;
    std::vector<double> m_areasUpTo;  // sums, this triangle's included
};

}  // namespace rubble
