#pragma once

#include "core/base/Random.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/DensityImage.h"
#include "core/geometry/Polygon.h"

#include <array>
#include <vector>

namespace rubble {

/// How dense a picture is at a place of it, in [0, 1]: (0, 0) is its lower left corner, (1, 1) the upper right one.
double densityAt(const GreyImage& image, DenseWhere dense, Vec2 place);

/// Gives random points of a polygon at the density of a picture that is stretched over its bounding box. The polygon is cut into
/// triangles and those along the pixels; of all these parts one is drawn by its weight: every draw takes four numbers of the
/// stream and hits.
class DensityArea {
public:
    /// `image` is verified and stays there.
    ///
    /// Errors: those of triangles(); Cancelled.
    static Result<DensityArea> of(const Polygon& polygon, const GreyImage& image, DenseWhere dense,
                                  const TaskContext& task = {});

    /// True where the picture leaves no density anywhere in the polygon.
    bool isEmpty() const { return m_weightsUpTo.empty(); }
    /// Only where not isEmpty().
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
    std::vector<double> m_weightsUpTo;  // sums of area * density, this part's included
};

}  // namespace rubble
