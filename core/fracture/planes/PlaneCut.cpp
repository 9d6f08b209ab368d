#include "core/fracture/planes/PlaneCut.h"

#include "core/fracture/solid/FaceLoops.h"
#include "core/fracture/solid/LoopNesting.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {
namespace {

/// A triangle's part on one side: three or four corners.
struct SidePart {
    std::array<std::uint32_t, 4> corners{};
    std::size_t count = 0;
    void add(std::uint32_t corner) { corners[count++] = corner; }
};

class PlaneCutter {
public:
    PlaneCutter(std::span<const SolidTriangle> surface, std::vector<Vec3>& points, const SectionPlane& plane,
                double tolerance)
        : m_surface(surface), m_points(points), m_normal(plane.normal()), m_tolerance(tolerance) {
        m_heights.reserve(points.size());
        for (const Vec3 point : points) {
            const double height = glm::dot(point - plane.origin, m_normal);
            m_heights.push_back(std::abs(height) <= tolerance ? 0.0 : height);
        }
    }

    PlaneCut cut() {
        findEdges();
        SolidFaces& faces = m_result.faces;
        const std::size_t count = m_surface.size() + 4 * m_result.edges.size();
        faces.faces.reserve(count);
        faces.triangles.reserve(count);
        faces.firstTriangle.reserve(count + 1);
        faces.firstLoop.reserve(count + 1);
        faces.firstCorner.reserve(count + 1);
        faces.corners.reserve(3 * count);
        for (const SolidTriangle& triangle : m_surface) addTriangle(triangle);
        addCap();
        return std::move(m_result);
    }

private:
    bool isCut(std::uint32_t a, std::uint32_t b) const {
        return (m_heights[a] < 0.0 && m_heights[b] > 0.0) || (m_heights[a] > 0.0 && m_heights[b] < 0.0);
    }

    /// Finds the edges that are cut, and places their points.
    void findEdges() {
        std::vector<PlaneCrossing>& edges = m_result.edges;
        for (const SolidTriangle& triangle : m_surface) {
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t a = triangle.corners[k], b = triangle.corners[(k + 1) % 3];
                if (a < b && isCut(a, b)) edges.push_back({a, b, 0});  // the surface is closed: it is there both ways
            }
        }
        std::sort(edges.begin(), edges.end(), [](const PlaneCrossing& a, const PlaneCrossing& b) {
            return a.low != b.low ? a.low < b.low : a.high < b.high;
        });
        const auto isSame = [](const PlaneCrossing& a, const PlaneCrossing& b) {
            return a.low == b.low && a.high == b.high;
        };
        edges.erase(std::unique(edges.begin(), edges.end(), isSame), edges.end());
        for (PlaneCrossing& edge : edges) {
            edge.point = static_cast<std::uint32_t>(m_points.size());
            const double low = m_heights[edge.low], high = m_heights[edge.high];
            const Vec3 start = m_points[edge.low];
            m_points.push_back(start + low / (low - high) * (m_points[edge.high] - start));
            m_heights.push_back(0.0);
        }
    }

    std::uint32_t pointOn(std::uint32_t a, std::uint32_t b) const {
        const auto [low, high] = std::minmax(a, b);
        const auto isBefore = [](const PlaneCrossing& edge, const std::pair<std::uint32_t, std::uint32_t>& ends) {
            return std::pair(edge.low, edge.high) < ends;
        };
        return std::lower_bound(m_result.edges.begin(), m_result.edges.end(), std::pair(low, high), isBefore)->point;
    }

    void addTriangle(const SolidTriangle& triangle) {
        SidePart below, above;
        bool isBelow = false, isAbove = false;  // strictly
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = triangle.corners[k], b = triangle.corners[(k + 1) % 3];
            const double height = m_heights[a];
            isBelow = isBelow || height < 0.0, isAbove = isAbove || height > 0.0;
            if (height <= 0.0) below.add(a);
            if (height >= 0.0) above.add(a);
            if (!isCut(a, b)) continue;
            const std::uint32_t point = pointOn(a, b);
            below.add(point);
            above.add(point);
        }
        if (!isBelow && !isAbove) isBelow = isFacingUp(triangle.corners), isAbove = !isBelow;
        if (isBelow) addPart(below, 0, triangle.tag);
        if (isAbove) addPart(above, 1, triangle.tag);
    }

    bool isFacingUp(const std::array<std::uint32_t, 3>& corners) const {
        const Vec3 a = m_points[corners[0]];
        return glm::dot(glm::cross(m_points[corners[1]] - a, m_points[corners[2]] - a), m_normal) > 0.0;
    }

    void addPart(const SidePart& part, std::uint32_t cell, std::uint32_t tag) {
        const auto& [a, b, c, d] = part.corners;
        if (part.count == 3) return addSurface({a, b, c}, cell, tag);
        const bool isFirstShorter = glm::length(m_points[c] - m_points[a]) <= glm::length(m_points[d] - m_points[b]);
        addSurface(isFirstShorter ? std::array{a, b, c} : std::array{a, b, d}, cell, tag);
        addSurface(isFirstShorter ? std::array{a, c, d} : std::array{b, c, d}, cell, tag);
    }

    void addSurface(const std::array<std::uint32_t, 3>& triangle, std::uint32_t cell, std::uint32_t tag) {
        m_result.faces.triangles.push_back(triangle);
        m_result.faces.corners.insert(m_result.faces.corners.end(), triangle.begin(), triangle.end());
        m_result.faces.firstCorner.push_back(static_cast<std::uint32_t>(m_result.faces.corners.size()));
        endFace({cell, kNone, tag});
        if (cell == 0) {
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t from = triangle[k], to = triangle[(k + 1) % 3];
                if (m_heights[from] == 0.0 && m_heights[to] == 0.0) m_openEdges.push_back({to, from});
            }
        }
    }

    void endFace(const SolidPartition::Face& face) {
        SolidFaces& faces = m_result.faces;
        faces.faces.push_back(face);
        faces.firstTriangle.push_back(static_cast<std::uint32_t>(faces.triangles.size()));
        faces.firstLoop.push_back(static_cast<std::uint32_t>(faces.firstCorner.size()) - 1);
    }

    /// Closes what is below with faces in the plane, which close what is above, too: together both are closed.
    void addCap() {
        const PlaneView view(m_normal);
        std::vector<PointLoop> loops = linkedLoops(std::move(m_openEdges), m_points, view);
        if (loops.empty()) return;
        SolidFaces& faces = m_result.faces;
        for (const std::vector<PointLoop>& face : nestedLoops(std::move(loops), m_points, view)) {
            if (face.size() > 1 || !triangulateConvex(m_points, face[0], view, faces.triangles)) {
                triangulateFace(m_points, face, view, m_tolerance, faces.triangles);
            }
            for (const PointLoop& loop : face) {
                faces.corners.insert(faces.corners.end(), loop.begin(), loop.end());
                faces.firstCorner.push_back(static_cast<std::uint32_t>(faces.corners.size()));
            }
            endFace({0, 1, kNone});
        }
    }

    std::span<const SolidTriangle> m_surface;
    std::vector<Vec3>& m_points;
    Vec3 m_normal;
    double m_tolerance;
    std::vector<double> m_heights;       // of points; 0 in the plane
    std::vector<PointStep> m_openEdges;  // of what is below, in the plane, as a face there has them
    PlaneCut m_result;
};

/// Numbers the points of a surface that has most points of its partition.
void numberByTable(std::size_t pointCount, FragmentSurface& surface) {
    std::vector<std::uint32_t> numbers(pointCount, kNone);
    for (const std::uint32_t name : surface.names) numbers[name] = 0;
    surface.names.clear();
    for (std::uint32_t name = 0; name < pointCount; ++name) {
        if (numbers[name] == kNone) continue;
        numbers[name] = static_cast<std::uint32_t>(surface.names.size());
        surface.names.push_back(name);
    }
    for (SolidTriangle& triangle : surface.triangles) {
        for (std::uint32_t& corner : triangle.corners) corner = numbers[corner];
    }
}

}  // namespace

FragmentSurface surfaceOf(const SolidPartition& partition, std::uint32_t fragment) {
    FragmentSurface surface;
    const std::span<const SolidPartition::FaceSide> sides = partition.facesOf(fragment);
    for (std::uint32_t k = 0; k < sides.size(); ++k) {
        for (const auto& [a, b, c] : partition.trianglesOf(sides[k].face)) {
            surface.triangles.push_back({sides[k].isReversed ? std::array{a, c, b} : std::array{a, b, c}, k});
            surface.names.insert(surface.names.end(), {a, b, c});
        }
    }
    if (partition.points.size() <= 4 * surface.names.size()) {
        numberByTable(partition.points.size(), surface);
    } else {
        std::ranges::sort(surface.names);
        const auto repeated = std::ranges::unique(surface.names);
        surface.names.erase(repeated.begin(), repeated.end());
        const auto number = [&](std::uint32_t name) { return std::ranges::lower_bound(surface.names, name); };
        for (SolidTriangle& triangle : surface.triangles) {
            for (std::uint32_t& corner : triangle.corners) {
                corner = static_cast<std::uint32_t>(number(corner) - surface.names.begin());
            }
        }
    }
    for (const std::uint32_t name : surface.names) surface.points.push_back(partition.points[name]);
    return surface;
}

PlaneCut cutByPlane(std::span<const SolidTriangle> surface, std::vector<Vec3>& points, const SectionPlane& plane,
                    double tolerance) {
    return PlaneCutter(surface, points, plane, tolerance).cut();
}

Result<SolidShells> shellsOf(const SolidFaces& faces, std::span<const Vec3> points, double tolerance,
                             const TaskContext& task) {
    std::vector<Vec3> scaled(points.begin(), points.end());
    for (Vec3& point : scaled) point *= kTieDistance / tolerance;
    return solidShells(faces, scaled, task);
}

double planeTolerance(const SolidPartition& partition) {
    Box3 box;
    for (const Vec3 point : partition.points) box.include(point);
    return kInPlane * box.diagonal();
}

}  // namespace rubble
