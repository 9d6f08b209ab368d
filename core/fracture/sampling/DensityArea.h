#pragma once

#include "core/base/Random.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/sampling/GreyImage.h"
#include "core/geometry/polygon/Polygon.h"

#include <array>
#include <vector>

namespace rubble {

/// The density of an image at a position, in [0, 1]: (0, 0) is the lower left corner, (1, 1) the upper right one.
double densityAt(const GreyImage& image, DenseWhere dense, Vec2 position);
/// The largest density of an image between two positions.
double maxDensityIn(const GreyImage& image, DenseWhere dense, Vec2 min, Vec2 max);

/// Random points of a polygon, with the density of an image that is stretched over its bounding box. The polygon is
/// divided into triangles, and these along the pixels; each point draws one of these parts by weight and a point in it:
/// four random numbers, without rejection.
class DensityArea {
public:
    /// `image` is verified and borrowed.
    ///
    /// Errors: those of triangles(); Cancelled.
    static Result<DensityArea> of(const Polygon& polygon, const GreyImage& image, DenseWhere dense,
                                  const TaskContext& task = {});

    /// Whether the density is zero everywhere in the polygon.
    bool isEmpty() const { return m_weightsUpTo.empty(); }
    /// The integral of the density over the polygon, m².
    double weight() const { return isEmpty() ? 0.0 : m_weightsUpTo.back(); }
    /// Precondition: not isEmpty().
    Vec2 point(Random& random) const;

private:
    struct Part {
        std::uint32_t triangle = 0;
        std::uint16_t column = 0;  // of its pixel
        std::uint16_t row = 0;     // from the top
    };
    DensityArea(const Polygon& polygon, const GreyImage& image);
    void clipToRow(std::uint32_t triangle, std::uint32_t row, Ring& clipped) const;
    void clipToColumn(const Ring& ofRow, std::uint32_t column, Ring& clipped) const;
    void addRow(std::uint32_t triangle, std::uint32_t row, DenseWhere dense);
    double xOf(std::uint32_t column) const;
    double yOf(std::uint32_t row) const;

    const GreyImage* m_image;
    Box2 m_box;
    std::vector<std::array<Vec2, 3>> m_triangles;
    std::vector<Part> m_parts;
    std::vector<double> m_weightsUpTo;  // cumulative sums of area * density
};

}  // namespace rubble
