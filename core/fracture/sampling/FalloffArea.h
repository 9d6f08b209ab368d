#pragma once

#include "core/base/Random.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/geometry/polygon/Polygon.h"

#include <array>
#include <vector>

namespace rubble {

/// A density that decreases with the distance d from a centre: (1 + (d/radius)²)^(-falloff/2).
struct Falloff {
    static constexpr double kMinRadiusFraction = 1e-6;  // of a domain's diameter: smaller radii are raised to it

    Vec2 centre{0.0, 0.0};  // m
    double radius = 1.0;    // m, > 0
    double falloff = 0.0;   // >= 0

    double at(double distance) const;
};

/// Random points of a polygon, with a density that decreases with the distance from a centre, which may lie outside.
/// The polygon is divided into triangles of nearly constant density; each point draws a triangle by weight, and a point
/// in it by rejection. A radius below a millionth of the polygon's diameter is raised to that.
class FalloffArea {
public:
    /// Errors: those of triangles(); Cancelled.
    static Result<FalloffArea> of(const Polygon& polygon, const Falloff& falloff, const TaskContext& task = {});

    Vec2 point(Random& random) const;
    /// The number of triangles.
    std::size_t partCount() const { return m_parts.size(); }

private:
    using Corners = std::array<Vec2, 3>;
    struct Part {
        Corners corners;
        double maxDensity = 0.0;  // upper bound in the triangle
    };
    explicit FalloffArea(const Falloff& falloff) : m_falloff(falloff) {}
    void add(const Corners& corners);

    Falloff m_falloff;
    std::vector<Part> m_parts;
    std::vector<double> m_weightsUpTo;  // cumulative sums of area * maxDensity
};

}  // namespace rubble
