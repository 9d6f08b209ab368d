#include "tests/oracle/ExactSolid.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace rubble::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using SpacePoint = Kernel::Point_3;
using Plane = Kernel::Plane_3;
using Surface = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;

SpacePoint exactPoint(Vec3 point) { return {point.x, point.y, point.z}; }

/// The shells of a mesh: lists of triangles that are joined by points.
std::vector<std::vector<std::array<std::uint32_t, 3>>> shellsOf(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> root(mesh.points.size());
    std::iota(root.begin(), root.end(), 0u);
    const auto rootOf = [&](std::uint32_t point) {
        while (root[point] != point) point = root[point];
        return point;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        root[rootOf(a)] = rootOf(b);
        root[rootOf(b)] = rootOf(c);
    }
    std::map<std::uint32_t, std::vector<std::array<std::uint32_t, 3>>> shells;
    for (const auto& triangle : mesh.triangles) shells[rootOf(triangle[0])].push_back(triangle);
    std::vector<std::vector<std::array<std::uint32_t, 3>>> all;
    for (auto& [first, shell] : shells) all.push_back(std::move(shell));
    return all;
}

Nef nefOf(const TriangleMesh& mesh, std::vector<std::array<std::uint32_t, 3>> shell) {
    if (exactVolume(mesh.points, shell) < 0.0) {
        for (auto& triangle : shell) std::swap(triangle[1], triangle[2]);
    }
    std::map<std::uint32_t, std::size_t> numbers;
    std::vector<SpacePoint> points;
    std::vector<std::vector<std::size_t>> faces;
    for (const auto& triangle : shell) {
        faces.emplace_back();
        for (const std::uint32_t corner : triangle) {
            const auto [number, isNew] = numbers.try_emplace(corner, points.size());
            if (isNew) points.push_back(exactPoint(mesh.points[corner]));
            faces.back().push_back(number->second);
        }
    }
    Surface surface;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, surface);
    return Nef(surface);
}

/// The solid in a mesh: shells are added, and cavities removed, the largest first, so that they may be nested.
Nef nefOf(const TriangleMesh& mesh) {
    std::vector<std::pair<double, std::vector<std::array<std::uint32_t, 3>>>> shells;
    for (auto& shell : shellsOf(mesh)) shells.emplace_back(exactVolume(mesh.points, shell), std::move(shell));
    std::ranges::sort(shells, [](const auto& a, const auto& b) { return std::abs(a.first) > std::abs(b.first); });
    Nef solid(Nef::EMPTY);
    for (const auto& [volume, shell] : shells) {
        if (volume > 0.0)
            solid += nefOf(mesh, shell);
        else
            solid -= nefOf(mesh, shell);
    }
    return solid.regularization();
}

/// A convex cell with the planes between it and its neighbours.
struct Cell {
    Surface surface;
    std::map<std::uint32_t, Plane> planes;  // of neighbours: negative on this side
};

/// The part of a convex polyhedron on the negative side of a plane.
Surface clipped(const Surface& convex, const Plane& plane) {
    std::vector<SpacePoint> points;
    for (auto point = convex.points_begin(); point != convex.points_end(); ++point) {
        if (plane.oriented_side(*point) != CGAL::ON_POSITIVE_SIDE) points.push_back(*point);
    }
    for (auto edge = convex.edges_begin(); edge != convex.edges_end(); ++edge) {
        const SpacePoint &a = edge->vertex()->point(), &b = edge->opposite()->vertex()->point();
        if (plane.oriented_side(a) * plane.oriented_side(b) != CGAL::NEGATIVE) continue;
        const Number atA = plane.a() * a.x() + plane.b() * a.y() + plane.c() * a.z() + plane.d();
        const Number atB = plane.a() * b.x() + plane.b() * b.y() + plane.c() * b.z() + plane.d();
        points.push_back(a + (b - a) * (atA / (atA - atB)));
        CGAL::exact(points.back());  // the numbers stay short: it is an intersection of three planes of the input
    }
    Surface hull;
    CGAL::convex_hull_3(points.begin(), points.end(), hull);
    return hull;
}

/// A box around all, with a wide margin.
Surface boxAround(const TriangleMesh& mesh, std::span<const Vec3> seeds) {
    Vec3 low = mesh.points[0], high = low;
    const auto include = [&](Vec3 point) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], point[axis]);
            high[axis] = std::max(high[axis], point[axis]);
        }
    };
    for (const Vec3 point : mesh.points) include(point);
    for (const Vec3 seed : seeds) include(seed);
    std::vector<SpacePoint> corners;
    for (int k = 0; k < 8; ++k) {
        const auto at = [&](int axis) { return (k >> axis & 1) == 0 ? low[axis] - 1.0 : high[axis] + 1.0; };
        corners.emplace_back(at(0), at(1), at(2));
    }
    Surface box;
    CGAL::convex_hull_3(corners.begin(), corners.end(), box);
    return box;
}

Cell cellOf(std::uint32_t seed, std::span<const Vec3> seeds, const Surface& box) {
    Cell cell{box, {}};
    for (std::uint32_t other = 0; other < seeds.size(); ++other) {
        if (other == seed) continue;
        // Positive where the other seed is.
        const Plane plane = CGAL::bisector(exactPoint(seeds[other]), exactPoint(seeds[seed]));
        bool isCut = false, isTouched = false;
        for (auto point = cell.surface.points_begin(); point != cell.surface.points_end(); ++point) {
            const CGAL::Oriented_side side = plane.oriented_side(*point);
            isCut = isCut || side == CGAL::ON_POSITIVE_SIDE;
            isTouched = isTouched || side == CGAL::ON_ORIENTED_BOUNDARY;
        }
        if (isCut) cell.surface = clipped(cell.surface, plane);
        if (isCut || isTouched) cell.planes.emplace(other, plane);
    }
    return cell;
}

using Facet = Nef::Halffacet_const_handle;

/// Calls visit(from, to) for the edges of a facet, counter-clockwise seen from the side of its plane.
template <class Visit>
void forEachEdge(Facet facet, const Visit& visit) {
    for (auto cycle = facet->facet_cycles_begin(); cycle != facet->facet_cycles_end(); ++cycle) {
        if (!cycle.is_shalfedge()) continue;
        const Nef::SHalfedge_const_handle first = cycle;
        Nef::SHalfedge_around_facet_const_circulator edge(first);
        const Nef::SHalfedge_around_facet_const_circulator last = edge;
        do {
            const SpacePoint& from = edge->source()->source()->point();
            ++edge;
            visit(from, edge->source()->source()->point());
        } while (edge != last);
    }
}

double areaOf(Facet facet) {
    Kernel::Vector_3 twice(0, 0, 0);
    forEachEdge(facet, [&](const SpacePoint& a, const SpacePoint& b) {
        twice = twice + CGAL::cross_product(a - CGAL::ORIGIN, b - CGAL::ORIGIN);
    });
    return std::sqrt(CGAL::to_double(twice.squared_length())) / 2.0;
}

/// Counts what a shell of a solid consists of.
struct ShellCounter {
    long corners = 0, edgeSides = 0, facets = 0;
    Number sixVolumes = 0;

    void visit(Nef::SFace_const_handle fan) {
        for (auto cycle = fan->sface_cycles_begin(); cycle != fan->sface_cycles_end(); ++cycle) ++corners;
    }
    void visit(Facet facet) {
        facets += 2;
        for (auto cycle = facet->facet_cycles_begin(); cycle != facet->facet_cycles_end(); ++cycle) --facets;
        // The plane looks into the solid, so that cycles are clockwise from outside.
        SpacePoint first;
        bool isFirst = true;
        forEachEdge(facet, [&](const SpacePoint& a, const SpacePoint& b) {
            if (isFirst) first = a, isFirst = false;
            ++edgeSides;
            sixVolumes -= CGAL::determinant(first - CGAL::ORIGIN, a - CGAL::ORIGIN, b - CGAL::ORIGIN);
        });
    }
    void visit(Nef::Vertex_const_handle) {}
    void visit(Nef::Halfedge_const_handle) {}
    void visit(Nef::SHalfedge_const_handle) {}
    void visit(Nef::SHalfloop_const_handle) {}

    int eulerNumber() const { return static_cast<int>(corners - edgeSides / 2 + facets); }
};

void measure(const Nef& solid, ExactSolidCell& cell) {
    Number sixVolumes = 0;
    for (auto volume = solid.volumes_begin(); volume != solid.volumes_end(); ++volume) {
        if (!volume->mark()) continue;
        ++cell.parts;
        for (auto shell = volume->shells_begin(); shell != volume->shells_end(); ++shell) {
            ShellCounter counter;
            solid.visit_shell_objects(Nef::SFace_const_handle(shell), counter);
            ++cell.shells;
            cell.eulerNumber += counter.eulerNumber();
            sixVolumes += counter.sixVolumes;
        }
    }
    cell.volume = CGAL::to_double(sixVolumes) / 6.0;
}

/// The area of the facets of a solid in a plane that looks out of it.
double areaIn(const Nef& solid, const Plane& plane) {
    double area = 0.0;
    for (auto facet = solid.halffacets_begin(); facet != solid.halffacets_end(); ++facet) {
        if (facet->incident_volume()->mark() && facet->plane().opposite() == plane) area += areaOf(facet);
    }
    return area;
}

/// The area in which two solids touch, that have a plane between them.
double commonArea(const Nef& a, const Nef& b) {
    const Nef common = a.intersection(b);
    double area = 0.0;
    for (auto facet = common.halffacets_begin(); facet != common.halffacets_end(); ++facet) {
        if (facet->mark()) area += areaOf(facet) / 2.0;  // both of its sides are visited
    }
    return area;
}

}  // namespace

std::vector<ExactSolidCell> exactSolidCells(const TriangleMesh& mesh, std::span<const Vec3> seeds) {
    const Nef solid = nefOf(mesh);
    const Surface box = boxAround(mesh, seeds);
    std::vector<Cell> cells;
    std::vector<Nef> solids;
    std::vector<ExactSolidCell> results(seeds.size());
    for (std::uint32_t seed = 0; seed < seeds.size(); ++seed) {
        cells.push_back(cellOf(seed, seeds, box));
        solids.push_back(solid.intersection(Nef(cells[seed].surface)).regularization());
        measure(solids[seed], results[seed]);
    }
    const auto isOfMesh = [&](const Plane& plane) {
        return std::ranges::any_of(mesh.triangles, [&](const auto& triangle) {
            return std::ranges::all_of(
                triangle, [&](std::uint32_t corner) { return plane.has_on(exactPoint(mesh.points[corner])); });
        });
    };
    for (std::uint32_t seed = 0; seed < seeds.size(); ++seed) {
        for (const auto& [other, plane] : cells[seed].planes) {
            if (other < seed) continue;
            // Where the surface lies in the plane, a facet there need not be one between the cells.
            const double area = isOfMesh(plane) ? commonArea(solids[seed], solids[other]) : areaIn(solids[seed], plane);
            if (area == 0.0) continue;
            results[seed].shared.emplace_back(other, area);
            results[other].shared.emplace_back(seed, area);
        }
    }
    for (ExactSolidCell& cell : results) std::ranges::sort(cell.shared);
    return results;
}

bool isNefMesh(const TriangleMesh& mesh) {
    std::vector<std::vector<std::size_t>> faces;
    for (const auto& [a, b, c] : mesh.triangles) faces.push_back({a, b, c});
    return !faces.empty() && CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(faces);
}

double exactVolume(std::span<const Vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles) {
    CGAL::Gmpq six = 0;
    const auto exact = [&](std::uint32_t index) {
        return std::array<CGAL::Gmpq, 3>{points[index].x, points[index].y, points[index].z};
    };
    for (const auto& [ia, ib, ic] : triangles) {
        const auto a = exact(ia), b = exact(ib), c = exact(ic);
        six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return CGAL::to_double(six / 6);
}

}  // namespace rubble::oracle
