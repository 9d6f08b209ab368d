#include "core/fracture/sampling/DensityArea.h"

#include "core/base/Assert.h"
#include "core/fracture/sampling/TriangleSampling.h"
#include "core/geometry/polygon/ConvexParts.h"
#include "core/geometry/polygon/HalfPlaneClip.h"

#include <algorithm>

namespace rubble {
namespace {

/// In [0, 1].
double densityOf(const GreyImage& image, std::size_t pixel, DenseWhere dense) {
    const double white = image.white();
    const double grey = image.grey[pixel] / white;
    const double opacity = image.opacity.empty() ? 1.0 : image.opacity[pixel] / white;
    return (dense == DenseWhere::Bright ? grey : 1.0 - grey) * opacity;
}

/// The index of the step that contains a position, of `count` equal steps from `from` to `to`.
std::uint32_t stepAt(double position, double from, double to, std::uint32_t count) {
    const double step = (position - from) / (to - from) * count;
    return static_cast<std::uint32_t>(std::clamp(step, 0.0, count - 1.0));
}

/// A uniform random point of a convex ring.
Vec2 pointOf(const Ring& ring, Random& random) {
    double drawn = random.unit() * signedArea(ring);
    std::size_t k = 1;
    for (; k + 2 < ring.size(); ++k) {
        const double triangle = cross(ring[k] - ring[0], ring[k + 1] - ring[0]) / 2.0;
        if (drawn < triangle) break;
        drawn -= triangle;
    }
    return pointOfTriangle(ring[0], ring[k] - ring[0], ring[k + 1] - ring[0], random);
}

}  // namespace

double densityAt(const GreyImage& image, DenseWhere dense, Vec2 position) {
    const std::uint32_t column = stepAt(position.x, 0.0, 1.0, image.width),
                        row = stepAt(position.y, 1.0, 0.0, image.height);
    return densityOf(image, std::size_t{row} * image.width + column, dense);
}

double maxDensityIn(const GreyImage& image, DenseWhere dense, Vec2 min, Vec2 max) {
    const std::uint32_t left = stepAt(min.x, 0.0, 1.0, image.width), right = stepAt(max.x, 0.0, 1.0, image.width),
                        bottom = stepAt(min.y, 1.0, 0.0, image.height), top = stepAt(max.y, 1.0, 0.0, image.height);
    double most = 0.0;
    for (std::uint32_t row = top; row <= bottom; ++row) {
        for (std::uint32_t column = left; column <= right; ++column)
            most = std::max(most, densityOf(image, std::size_t{row} * image.width + column, dense));
    }
    return most;
}

DensityArea::DensityArea(const Polygon& polygon, const GreyImage& image)
    : m_image(&image), m_box(boundsOf(polygon.outer)) {}

double DensityArea::xOf(std::uint32_t column) const {
    return m_box.min.x + m_box.size().x * (static_cast<double>(column) / m_image->width);
}

/// The upper edge of a row.
double DensityArea::yOf(std::uint32_t row) const {
    return m_box.max.y - m_box.size().y * (static_cast<double>(row) / m_image->height);
}

void DensityArea::clipToRow(std::uint32_t triangle, std::uint32_t row, Ring& clipped) const {
    Ring below;
    clipByHalfPlane(m_triangles[triangle], {{0.0, 1.0}, yOf(row)}, below);
    clipByHalfPlane(below, {{0.0, -1.0}, -yOf(row + 1)}, clipped);
}

void DensityArea::clipToColumn(const Ring& ofRow, std::uint32_t column, Ring& clipped) const {
    Ring left;
    clipByHalfPlane(ofRow, {{1.0, 0.0}, xOf(column + 1)}, left);
    clipByHalfPlane(left, {{-1.0, 0.0}, -xOf(column)}, clipped);
}

Result<DensityArea> DensityArea::of(const Polygon& polygon, const GreyImage& image, DenseWhere dense,
                                    const TaskContext& task) {
    const Result<IndexLoops> loops = triangles(polygon);
    if (!loops) return loops.error();
    const std::vector<Vec2> corners = cornersOf(polygon);
    DensityArea area(polygon, image);
    for (const std::vector<std::uint32_t>& loop : *loops) {
        const auto number = static_cast<std::uint32_t>(area.m_triangles.size());
        const auto& triangle =
            area.m_triangles.emplace_back(std::array{corners[loop[0]], corners[loop[1]], corners[loop[2]]});
        const Box2 box = boundsOf(triangle);
        const Box2 all = area.m_box;
        const std::uint32_t last = stepAt(box.min.y, all.max.y, all.min.y, image.height);
        for (std::uint32_t row = stepAt(box.max.y, all.max.y, all.min.y, image.height); row <= last; ++row) {
            if (task.isCancelled()) return TaskContext::cancelled();
            area.addRow(number, row, dense);
        }
    }
    return area;
}

void DensityArea::addRow(std::uint32_t triangle, std::uint32_t row, DenseWhere dense) {
    Ring ofRow, ofPixel;
    clipToRow(triangle, row, ofRow);
    if (ofRow.size() < 3) return;
    const Box2 box = boundsOf(ofRow);
    const std::uint32_t last = stepAt(box.max.x, m_box.min.x, m_box.max.x, m_image->width);
    for (std::uint32_t column = stepAt(box.min.x, m_box.min.x, m_box.max.x, m_image->width); column <= last; ++column) {
        const double density = densityOf(*m_image, std::size_t{row} * m_image->width + column, dense);
        if (density == 0.0) continue;
        clipToColumn(ofRow, column, ofPixel);
        const double weight = ofPixel.size() < 3 ? 0.0 : density * signedArea(ofPixel);
        if (weight <= 0.0) continue;
        m_parts.push_back({triangle, static_cast<std::uint16_t>(column), static_cast<std::uint16_t>(row)});
        m_weightsUpTo.push_back((m_weightsUpTo.empty() ? 0.0 : m_weightsUpTo.back()) + weight);
    }
}

Vec2 DensityArea::point(Random& random) const {
    RUBBLE_ASSERT(!isEmpty());
    const Part& part = m_parts[drawByWeight(m_weightsUpTo, random)];
    Ring ofRow, ofPixel;
    clipToRow(part.triangle, part.row, ofRow);
    clipToColumn(ofRow, part.column, ofPixel);
    return pointOf(ofPixel, random);
}

}  // namespace rubble
