#include "tests/oracle/ExactVoronoi.h"

#include "tests/oracle/OutlineTriangles.h"
#include "tests/oracle/RationalConvex.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace rubble::oracle {
namespace {

using SiteVertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Predicates>;
using SiteStructure = CGAL::Triangulation_data_structure_2<SiteVertex>;
using SiteTriangulation = CGAL::Delaunay_triangulation_2<Predicates, SiteStructure>;

/// The neighbours of each seed in CGAL's Delaunay triangulation.
struct Neighbours {
    std::vector<std::vector<std::uint32_t>> of;
    std::vector<std::uint32_t> sameAs;
};

Neighbours neighboursOf(std::span<const Vec2> seeds) {
    Neighbours neighbours{std::vector<std::vector<std::uint32_t>>(seeds.size()),
                          std::vector<std::uint32_t>(seeds.size(), ExactCell::kSelf)};
    SiteTriangulation triangulation;
    for (std::uint32_t seed = 0; seed < seeds.size(); ++seed) {
        const std::size_t before = triangulation.number_of_vertices();
        const auto vertex = triangulation.insert(Predicates::Point_2(seeds[seed].x, seeds[seed].y));
        if (triangulation.number_of_vertices() == before)
            neighbours.sameAs[seed] = vertex->info();
        else
            vertex->info() = seed;
    }
    for (auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end(); ++edge) {
        const auto one = edge->first->vertex(SiteTriangulation::cw(edge->second))->info();
        const auto other = edge->first->vertex(SiteTriangulation::ccw(edge->second))->info();
        neighbours.of[one].push_back(other);
        neighbours.of[other].push_back(one);
    }
    return neighbours;
}

/// A counter-clockwise box that contains the outline with a wide margin.
Convex boxAround(const Polygon& outline) {
    Vec2 low = outline.outer[0];
    Vec2 high = low;
    for (const Vec2 corner : outline.outer) {
        low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
        high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
    }
    const double margin = (high.x - low.x) + (high.y - low.y);
    low -= Vec2(margin, margin);
    high += Vec2(margin, margin);
    const std::array<Point, 4> corners{Point(low.x, low.y), Point(high.x, low.y), Point(high.x, high.y),
                                       Point(low.x, high.y)};
    Convex convex;
    for (std::size_t k = 0; k < 4; ++k) {
        convex.corners.push_back(corners[k]);
        convex.sides.push_back({Line(corners[k], corners[(k + 1) % 4]), Side::kUnnamed});
    }
    return convex;
}

/// Disjoint sets.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : m_parent(count) { std::iota(m_parent.begin(), m_parent.end(), 0u); }
    std::size_t of(std::size_t member) const {
        while (m_parent[member] != member) member = m_parent[member];
        return member;
    }
    void merge(std::size_t one, std::size_t other) { m_parent[of(one)] = of(other); }

private:
    std::vector<std::size_t> m_parent;
};

/// A cell's part in one triangle of the outline.
struct Part {
    std::size_t triangle;
    Convex region;
    double area;
    double perimeter;
};

/// The name of a side that a cell gets from side k of a triangle is kCutBase + k.
constexpr std::uint32_t kCutBase = 0xfffffff0u;

std::vector<Part> partsOf(const Convex& cell, const OutlineTriangles& triangles) {
    std::vector<Part> parts;
    const CGAL::Bbox_2 box = cell.box();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (!CGAL::do_overlap(box, triangles[t].box)) continue;
        Convex region = cell;
        for (std::uint32_t k = 0; k < 3 && !region.isEmpty(); ++k)
            region = clipped(region, {triangles[t].sides[k], kCutBase + k});
        if (!region.isEmpty()) parts.push_back({t, region, areaOf(region), perimeterOf(region)});
    }
    return parts;
}

/// The length of the part's side along side k of its triangle; 0 if there is none.
double crossSectionLength(const Part& part, std::uint32_t k) {
    double length = 0.0;
    for (std::size_t s = 0; s < part.region.sides.size(); ++s)
        if (part.region.sides[s].name == kCutBase + k) length += part.region.lengthOf(s);
    return length;
}

/// The number of connected pieces, where parts that share more than `minNeck` are connected; pieces nowhere wider than
/// `minWidth` are not counted.
std::uint32_t pieceCount(const std::vector<Part>& parts, const OutlineTriangles& triangles, double minNeck,
                         double minWidth) {
    DisjointSets groups(parts.size());
    std::map<std::size_t, std::size_t> partIn;
    for (std::size_t p = 0; p < parts.size(); ++p) partIn[parts[p].triangle] = p;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const auto neighbour = partIn.find(triangles[parts[p].triangle].neighbours[k]);
            if (neighbour != partIn.end() && crossSectionLength(parts[p], k) > minNeck)
                groups.merge(p, neighbour->second);
        }
    }
    std::vector<double> width(parts.size(), 0.0);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        double& widest = width[groups.of(p)];
        widest = std::max(widest, 2.0 * parts[p].area / parts[p].perimeter);
    }
    return static_cast<std::uint32_t>(
        std::count_if(width.begin(), width.end(), [&](double w) { return w > minWidth; }));
}

/// Adds the lengths of the part's sides that lie on bisectors and inside the outline.
void addShared(const Part& part, const OutlineTriangle& triangle, std::map<std::uint32_t, double>& shared) {
    for (std::size_t s = 0; s < part.region.sides.size(); ++s) {
        const std::uint32_t name = part.region.sides[s].name;
        if (name == Side::kUnnamed || name >= kCutBase) continue;
        bool liesOnWall = false;
        for (std::size_t k = 0; k < 3; ++k)
            if (triangle.neighbours[k] == OutlineTriangle::kOutside && part.region.liesOn(s, triangle.sides[k]))
                liesOnWall = true;
        if (!liesOnWall) shared[name] += part.region.lengthOf(s);
    }
}

ExactCell summed(const std::vector<Part>& parts, const OutlineTriangles& triangles, const Point& origin, double hair) {
    ExactCell cell;
    std::map<std::uint32_t, double> shared;
    Vec2 moment{0.0, 0.0};
    for (const Part& part : parts) {
        cell.area += part.area;
        cell.perimeter += part.perimeter;
        moment += momentOf(part.region, origin);
        addShared(part, triangles[part.triangle], shared);
    }
    if (cell.area > 0.0) cell.centroid = moment / cell.area;
    cell.shared.assign(shared.begin(), shared.end());
    const std::uint32_t loose = pieceCount(parts, triangles, 0.0, hair);
    const std::uint32_t firm = pieceCount(parts, triangles, hair, 0.0);
    cell.minPieces = std::min(loose, firm);
    cell.maxPieces = std::max(loose, firm);
    return cell;
}

}  // namespace

std::vector<ExactCell> exactCells(const Polygon& outline, std::span<const Vec2> seeds, double hair) {
    const OutlineTriangles triangles = trianglesOf(outline);
    const Neighbours neighbours = neighboursOf(seeds);
    const Convex box = boxAround(outline);
    const Point origin(outline.outer[0].x, outline.outer[0].y);
    std::vector<ExactCell> cells(seeds.size());
    for (std::uint32_t seed = 0; seed < seeds.size(); ++seed) {
        cells[seed].sameAs = neighbours.sameAs[seed];
        if (cells[seed].sameAs != ExactCell::kSelf) continue;
        const Point site(seeds[seed].x, seeds[seed].y);
        Convex cell = box;
        for (const std::uint32_t neighbour : neighbours.of[seed]) {
            if (cell.isEmpty()) break;
            cell = clipped(cell, {CGAL::bisector(site, Point(seeds[neighbour].x, seeds[neighbour].y)), neighbour});
        }
        if (!cell.isEmpty()) cells[seed] = summed(partsOf(cell, triangles), triangles, origin, hair);
    }
    return cells;
}

}  // namespace rubble::oracle
