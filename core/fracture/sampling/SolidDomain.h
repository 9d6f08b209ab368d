#pragma once

#include "core/fracture/sampling/SolidScatter.h"

namespace rubble {

/// A closed mesh in which seeds are placed. Copies share it.
class SolidDomain {
public:
    /// Errors: those of SolidSurface::of(); Degenerate if the mesh is as thin as rounding; Cancelled.
    static Result<SolidDomain> of(TriangleMesh mesh, const TaskContext& task = {});

    const SolidSurface& surface() const { return m_surface; }
    const TriangleMesh& mesh() const { return m_surface.mesh(); }
    const Box3& bounds() const { return m_surface.bounds(); }
    double volume() const { return m_surface.volume(); }  // m³
    /// Whether a point is inside or on the surface.
    bool contains(Vec3 point) const { return m_surface.contains(point); }
    /// The distance of a point to the surface, m: negative outside.
    double depth(Vec3 point) const { return m_surface.depth(point); }

    /// A uniform random point, see SolidScatter.
    Vec3 point(Random& random) const { return m_uniform->point(random); }
    /// A uniform random point within `radius` of a centre, which may be outside; nothing if there is none, or hardly
    /// any room.
    std::optional<Vec3> pointNear(Vec3 centre, double radius, Random& random) const {
        return m_uniform->pointNear(centre, radius, random);
    }

private:
    SolidDomain(const SolidSurface& surface, std::shared_ptr<const SolidScatter> uniform)
        : m_surface(surface), m_uniform(std::move(uniform)) {}

    SolidSurface m_surface;
    std::shared_ptr<const SolidScatter> m_uniform;
};

}  // namespace rubble
