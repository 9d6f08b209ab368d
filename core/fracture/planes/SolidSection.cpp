#include "core/fracture/planes/SolidSection.h"

#include "core/fracture/solid/FaceLoops.h"
#include "core/fracture/solid/LoopNesting.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rubble {
namespace {

/// A mesh as a partition of one fragment.
SolidPartition wholeOf(const TriangleMesh& mesh) {
    SolidPartition whole;
    whole.points = mesh.points;
    whole.triangles = mesh.triangles;
    const std::uint32_t count = static_cast<std::uint32_t>(mesh.triangles.size());
    whole.firstTriangle.resize(count + 1);
    std::iota(whole.firstTriangle.begin(), whole.firstTriangle.end(), 0u);
    for (std::uint32_t t = 0; t < count; ++t) whole.faces.push_back({0, kNone, t});
    whole.seedOfFragment = {0};
    whole.partOfFragment = {kNone};
    whole.fragmentOfSeed = {0};
    whole.listFaces();
    return whole;
}

/// A corner of a section: the edge of a solid that is cut there, from its lower to its higher point; a point in the
/// plane is an edge to itself. So all triangles around it name it alike.
using CornerName = std::uint64_t;
CornerName nameOf(std::uint32_t a, std::uint32_t b) {
    return static_cast<CornerName>(std::min(a, b)) << 32 | std::max(a, b);
}

/// An edge of a section, with the fragment on its left.
struct SectionEdge {
    std::uint32_t fragment;  // kNone: the outline
    std::uint32_t from, to;  // corners
};

/// Links the edges of a section.
class SectionBuilder {
public:
    SectionBuilder(const SolidPartition& partition, const std::vector<double>& heights, double height, double tolerance)
        : m_partition(partition), m_heights(heights), m_height(height), m_tolerance(tolerance) {}

    void addFace(std::uint32_t f) {
        const SolidPartition::Face& face = m_partition.faces[f];
        for (const std::array<std::uint32_t, 3>& t : m_partition.trianglesOf(f)) {
            CornerName from = 0, to = 0;
            int crossings = 0;
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t a = t[k], b = t[(k + 1) % 3];
                const double heightA = above(a), heightB = above(b);
                if ((heightA < 0.0) == (heightB < 0.0)) continue;
                const std::uint32_t upper = heightA < 0.0 ? b : a;
                const CornerName name = above(upper) == 0.0 ? nameOf(upper, upper) : nameOf(a, b);
                (heightA < 0.0 ? to : from) = name;
                ++crossings;
            }
            if (crossings == 0 || from == to) continue;
            m_names.insert(m_names.end(), {from, to});
            m_fragments.emplace_back(face.fragment, face.behind);
        }
    }

    SolidSection build(const SectionPlane& plane) {
        SolidSection section;
        section.plane = plane;
        const std::vector<SectionEdge> edges = sortedEdges(plane);
        std::vector<PointStep> steps;
        for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
            steps.clear();
            const std::uint32_t fragment = edges[begin].fragment;
            for (; end < edges.size() && edges[end].fragment == fragment; ++end) {
                steps.push_back({edges[end].from, edges[end].to});
            }
            SolidSection::Part part{fragment, polygonsOf(steps), 0.0, {}};
            for (const Polygon& polygon : part.polygons) part.area += area(polygon);
            if (fragment == kNone) {
                section.outline = std::move(part.polygons);
                section.area = part.area;
                continue;
            }
            for (const Polygon& polygon : part.polygons) {
                for (const Vec2 corner : polygon.outer) part.box.include(corner);
            }
            if (!part.polygons.empty()) section.parts.push_back(std::move(part));
        }
        return section;
    }

private:
    /// The height of a point above the plane; 0 in it.
    double above(std::uint32_t point) const {
        const double height = m_heights[point] - m_height;
        return std::abs(height) <= m_tolerance ? 0.0 : height;
    }

    /// Numbers and places the corners, and gives the edges of each fragment and of the outline, by fragment.
    std::vector<SectionEdge> sortedEdges(const SectionPlane& plane) {
        std::vector<CornerName> names = m_names;
        std::sort(names.begin(), names.end());
        names.erase(std::unique(names.begin(), names.end()), names.end());
        m_corners.reserve(names.size());
        for (const CornerName name : names) m_corners.push_back(placeOf(name, plane));
        const auto number = [&](CornerName name) {
            return static_cast<std::uint32_t>(std::lower_bound(names.begin(), names.end(), name) - names.begin());
        };
        std::vector<SectionEdge> edges;
        for (std::size_t k = 0; k < m_fragments.size(); ++k) {
            const std::uint32_t from = number(m_names[2 * k]), to = number(m_names[2 * k + 1]);
            const auto [fragment, behind] = m_fragments[k];
            edges.push_back({fragment, from, to});
            if (behind == kNone)
                edges.push_back({kNone, from, to});
            else
                edges.push_back({behind, to, from});
        }
        std::ranges::stable_sort(edges, {}, &SectionEdge::fragment);
        return edges;
    }

    Vec3 placeOf(CornerName name, const SectionPlane& plane) const {
        const std::uint32_t a = static_cast<std::uint32_t>(name >> 32), b = static_cast<std::uint32_t>(name);
        const Vec3 offset = m_partition.origin;
        const Vec2 start = plane.inPlane(offset + m_partition.points[a]);
        if (a == b) return {start, 0.0};
        const double heightA = above(a), heightB = above(b);
        return {start + heightA / (heightA - heightB) * (plane.inPlane(offset + m_partition.points[b]) - start), 0.0};
    }

    std::vector<Polygon> polygonsOf(const std::vector<PointStep>& steps) const {
        const PlaneView view(Vec3(0.0, 0.0, 1.0));
        std::vector<Polygon> polygons;
        const auto ringOf = [&](const PointLoop& loop) {
            Ring ring;
            ring.reserve(loop.size());
            for (const std::uint32_t corner : loop) ring.push_back(view(m_corners[corner]));
            return ring;
        };
        for (const std::vector<PointLoop>& loops : nestedLoops(linkedLoops(steps, m_corners, view), m_corners, view)) {
            Polygon polygon{ringOf(loops[0]), {}};
            if (!(signedArea(polygon.outer) > 0.0)) continue;  // nothing but rounding
            for (std::size_t hole = 1; hole < loops.size(); ++hole) polygon.holes.push_back(ringOf(loops[hole]));
            polygons.push_back(std::move(polygon));
        }
        return polygons;
    }

    const SolidPartition& m_partition;
    const std::vector<double>& m_heights;
    double m_height, m_tolerance;
    std::vector<CornerName> m_names;                                   // of edges: from, to
    std::vector<std::pair<std::uint32_t, std::uint32_t>> m_fragments;  // of edges: on the left, on the right
    std::vector<Vec3> m_corners;                                       // in the plane's axes; z is 0
};

}  // namespace

std::uint32_t fragmentAt(const SolidSection& section, Vec2 point) {
    for (const SolidSection::Part& part : section.parts) {
        if (point.x < part.box.min.x || point.y < part.box.min.y || point.x > part.box.max.x ||
            point.y > part.box.max.y) {
            continue;
        }
        for (const Polygon& polygon : part.polygons) {
            if (containment(polygon, point) != Containment::Outside) return part.fragment;
        }
    }
    return kNone;
}

SolidSlicer::SolidSlicer(std::shared_ptr<const SolidPartition> partition, const SectionPlane& plane)
    : m_partition(std::move(partition)), m_plane(plane) {
    const SolidPartition& p = *m_partition;
    Box3 box;
    m_heights.reserve(p.points.size());
    for (const Vec3 point : p.points) {
        box.include(point);
        m_heights.push_back(plane.heightOf(p.origin + point));
    }
    m_tolerance = kInPlane * box.diagonal();
    for (std::uint32_t f = 0; f < p.faces.size(); ++f) {
        double low = m_heights[p.trianglesOf(f)[0][0]], high = low;
        for (const std::array<std::uint32_t, 3>& triangle : p.trianglesOf(f)) {
            for (const std::uint32_t point : triangle) {
                low = std::min(low, m_heights[point]), high = std::max(high, m_heights[point]);
            }
        }
        m_low.push_back(low), m_high.push_back(high);
    }
    m_minHeight = std::ranges::min(m_low), m_maxHeight = std::ranges::max(m_high);
}

SolidSlicer::SolidSlicer(const TriangleMesh& mesh, const SectionPlane& plane)
    : SolidSlicer(std::make_shared<const SolidPartition>(wholeOf(mesh)), plane) {}

SolidSection SolidSlicer::at(double height) const {
    SectionBuilder builder(*m_partition, m_heights, height, m_tolerance);
    const double low = height - m_tolerance, high = height - m_tolerance;
    for (std::uint32_t f = 0; f < m_low.size(); ++f) {
        if (m_low[f] <= low && m_high[f] >= high) builder.addFace(f);
    }
    return builder.build(m_plane.movedUp(height));
}

SolidSection sectionOf(const SolidPartition& partition, const SectionPlane& plane) {
    // The slicer is gone before the partition is, so it need not own it.
    return SolidSlicer(std::shared_ptr<const SolidPartition>(std::shared_ptr<void>(), &partition), plane).at(0.0);
}

SolidSection sectionOf(const TriangleMesh& mesh, const SectionPlane& plane) { return SolidSlicer(mesh, plane).at(0.0); }

}  // namespace rubble
