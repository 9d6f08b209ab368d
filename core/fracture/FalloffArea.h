#pragma once

#include "core/base/Random.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/geometry/Polygon.h"

#include <array>
#include <vector>

namespace rubble {

/// A density that falls with the distance from a centre: (1 + (d/radius)²)^(-falloff/2).
struct Falloff {
    Vec2 centre{0.0, 0.0};  // m
    double radius = 1.0;    // m, > 0
    double falloff = 0.0;   // >= 0

    double at(double distance) const;
};

/// Gives random points of a polygon at a density that falls with the distance from a centre, wherever that lies. The polygon is cut
/// into triangles in which the density hardly changes; one is drawn by its weight, and a point of it is kept by the density there.
/// A radius below a millionth of the polygon's diameter counts as that: finer than this nothing is told apart.
class FalloffArea {
public:
    /// Errors: those of triangles(); Cancelled.
    static Result<FalloffArea> of(const Polygon& polygon, const Falloff& falloff, const TaskContext& task = {});

    Vec2 point(Random& random) const;
    /// How many triangles it was cut into.
    std::size_t partCount() const { return m_parts.size(); }

private:
    using Corners = std::array<Vec2, 3>;
    struct Part {
        Corners corners;
        double most = 0.0;  // no density in the triangle is greater
    };
    explicit FalloffArea(const Falloff& falloff) : m_falloff(falloff) {}
    void add(const Corners& corners);

    Falloff m_falloff;
    std::vector<Part> m_parts;
    std::vector<double> m_weightsUpTo;  // sums of area * most, this part's included
};

}  // namespace rubble
