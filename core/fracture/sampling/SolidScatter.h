#pragma once

#include "core/base/Random.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/sampling/SolidDensity.h"
#include "core/fracture/sampling/SolidSurface.h"

#include <optional>
#include <vector>

namespace rubble {

/// Random points of a closed mesh, with a density. The space around the mesh is divided into boxes, by halves, where
/// most points would miss; in each, what is solid is enclosed in a box that may be turned, so that few points miss a
/// thin plate or shell at any angle. A point draws one of these boxes by weight and a point in it, by rejection.
class SolidScatter {
public:
    /// Errors: Cancelled.
    static Result<SolidScatter> of(const SolidSurface& surface, const SolidDensity& density = {},
                                   const TaskContext& task = {});

    /// Whether the density is zero everywhere in the mesh.
    bool isEmpty() const { return m_parts.empty(); }
    std::size_t partCount() const { return m_parts.size(); }

    /// A random point. Of a solid nearly as thin as rounding it may lie beside the surface, as near as rounding.
    /// Precondition: not isEmpty().
    Vec3 point(Random& random) const;
    /// A random point within `radius` of a centre, which may be outside, with the density; nothing if there is no
    /// solid, or hardly any.
    std::optional<Vec3> pointNear(Vec3 centre, double radius, Random& random) const;

private:
    friend class SolidScatterBuilder;

    /// A box, and the solid in it as a box that may be turned.
    struct Part {
        Box3 box;              // what is outside belongs to other parts
        Mat3 axes{1.0};        // columns: unit vectors
        Box3 turned;           // along these axes
        double most = 1.0;     // upper bound of the density
        bool isSolid = false;  // all of the box

        double weight() const;
    };
    SolidScatter(const SolidSurface& surface, const SolidDensity& density) : m_surface(surface), m_density(density) {}
    std::optional<Vec3> pointOf(const Part& part, const Box3& turned, Random& random) const;

    SolidSurface m_surface;
    SolidDensity m_density;
    std::vector<Part> m_parts;
    std::vector<double> m_weightsUpTo;  // cumulative sums
};

}  // namespace rubble
