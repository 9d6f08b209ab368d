#pragma once

#include "core/asset/project/Surface.h"
#include "core/geometry/search/BoxTree.h"

#include <optional>
#include <vector>

namespace rubble {

/// An affine cap map at a point of the xy plane.
Vec2 mapped(const AffineUv& map, Vec2 point);

/// UV and material of a source mesh at one point.
struct SurfaceSample {
    Vec2 uv{0.0, 0.0};
    std::uint32_t material = 0;  // index into Surface::materials
};

/// The triangles of a surface, indexed for samples on caps and sides. Borrows the surface.
class SurfaceIndex {
public:
    explicit SurfaceIndex(const Surface& surface);

    /// The sample at `point`, on a face with the given centre and normal, which is parallel or perpendicular to z: from
    /// the nearest source triangle with a similar orientation, the first of equally near ones, at that triangle's
    /// nearest point, so never extrapolated. On an edge between triangles, the one towards the centre is used. O(log
    /// triangles) unless the triangles are slivers; adds the number of visited triangles to `visited`.
    SurfaceSample sample(Vec3 point, Vec3 faceCentre, Vec3 normal, std::size_t* visited = nullptr) const;

private:
    /// The triangles that can have a similar orientation to some faces.
    struct Part {
        std::vector<std::uint32_t> triangles;
        std::optional<BoxTree> tree;
    };

    void build(Part& part) const;
    const Part& partFor(Vec3 normal) const;

    const Surface& m_surface;
    std::vector<Vec3> m_normals;  // of the triangles, with twice their area as length
    Part m_front, m_back, m_sides;
};

}  // namespace rubble
