#pragma once

#include "core/geometry/predicates/Vec.h"
#include "core/geometry/search/Box3.h"

namespace rubble {

/// The number of steps of a SolidLattice along the diagonal of its box, at most.
inline constexpr double kLatticeSteps = 0x1p40;

/// The lattice that a solid and its seeds are moved to before they are cut, so that the signs that decide fit into
/// integers of fixed width. Its step is a power of two, at most 2⁻³⁹ of the diagonal: far below the tolerance of
/// meshes. Points on it are doubles without fraction in [0, kLatticeSteps].
class SolidLattice {
public:
    /// A lattice for points in a box that is not a point.
    explicit SolidLattice(const Box3& box);

    Vec3 origin() const { return m_origin; }
    double step() const { return m_step; }  // m
    /// A point in steps from the origin, and the nearest point of the lattice.
    Vec3 steps(Vec3 point) const { return (point - m_origin) / m_step; }
    Vec3 snapped(Vec3 point) const;
    /// A place in steps as metres from the origin.
    Vec3 metres(Vec3 steps) const { return steps * m_step; }

private:
    Vec3 m_origin;
    double m_step = 1.0;
};

}  // namespace rubble
