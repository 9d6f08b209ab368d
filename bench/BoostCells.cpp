#include "bench/Peers.h"

#include <boost/polygon/voronoi.hpp>

namespace rubble::bench {

namespace {

constexpr double kUnitsPerMetre = 0x1p30;

struct GridPoint {
    std::int32_t x, y;
};

using Diagram = boost::polygon::voronoi_diagram<double>;

Vec2 toVec2(const Diagram::vertex_type& vertex) { return {vertex.x() / kUnitsPerMetre, vertex.y() / kUnitsPerMetre}; }

std::vector<GridPoint> onGrid(std::span<const Vec2> seeds) {
    std::vector<GridPoint> points;
    points.reserve(seeds.size());
    for (const Vec2 seed : seeds) {
        points.push_back(
            {static_cast<std::int32_t>(seed.x * kUnitsPerMetre), static_cast<std::int32_t>(seed.y * kUnitsPerMetre)});
    }
    return points;
}

Vec2 siteOf(const std::vector<GridPoint>& points, const Diagram::cell_type& cell) {
    const GridPoint point = points[cell.source_index()];
    return Vec2{point.x, point.y} / kUnitsPerMetre;
}

}  // namespace
}  // namespace rubble::bench

template <>
struct boost::polygon::geometry_concept<rubble::bench::GridPoint> {
    using type = point_concept;
};

template <>
struct boost::polygon::point_traits<rubble::bench::GridPoint> {
    using coordinate_type = std::int32_t;
    static coordinate_type get(const rubble::bench::GridPoint& point, orientation_2d axis) {
        return axis == HORIZONTAL ? point.x : point.y;
    }
};

namespace rubble::bench {

Cells cellsByBoost(std::span<const Vec2> seeds) {
    const std::vector<GridPoint> points = onGrid(seeds);
    Diagram diagram;
    boost::polygon::construct_voronoi(points.begin(), points.end(), &diagram);
    CellWriter writer(seeds.size());
    std::vector<Vec2> neighbours;
    for (const Diagram::cell_type& cell : diagram.cells()) {
        const std::uint32_t seed = static_cast<std::uint32_t>(cell.source_index());
        const Diagram::edge_type* edge = cell.incident_edge();
        bool isUnbounded = false;
        do {
            if (edge->vertex0() == nullptr) {
                isUnbounded = true;
            } else {
                writer.addCorner(toVec2(*edge->vertex0()));
            }
            edge = edge->next();
        } while (edge != cell.incident_edge());
        if (!isUnbounded) {
            writer.endBounded(seed);
            continue;
        }
        neighbours.clear();
        do {
            neighbours.push_back(siteOf(points, *edge->twin()->cell()));
            edge = edge->next();
        } while (edge != cell.incident_edge());
        writer.endUnbounded(seed, siteOf(points, cell), neighbours);
    }
    return writer.take();
}

}  // namespace rubble::bench
