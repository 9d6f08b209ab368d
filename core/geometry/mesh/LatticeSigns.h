#pragma once

#include "core/geometry/predicates/Vec.h"

namespace rubble {

/// The signs of determinants of points on a SolidLattice, or twice as far out: exact for coordinates without fraction
/// in [0, 2⁴¹].

/// +1 if a, b, c are counter-clockwise seen against an axis (0, 1 or 2), -1 if clockwise, 0 if they are collinear from
/// there.
int areaSign(Vec3 a, Vec3 b, Vec3 c, int axis);

/// Whether three points lie on one line.
bool areCollinear(Vec3 a, Vec3 b, Vec3 c);

/// +1 if d is on the side of the plane of a, b, c from which they are counter-clockwise, -1 on the other, 0 in it.
int volumeSign(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

/// Compares points by their angles around a line from p to q, counter-clockwise seen against it, beginning at `first`,
/// which is not on it.
class AngleAround {
public:
    AngleAround(Vec3 p, Vec3 q, Vec3 first);

    /// Negative if a comes before b, 0 if they have the same angle, else positive. Neither may be on the line.
    int compare(Vec3 a, Vec3 b) const;

private:
    int quarterOf(Vec3 point) const;

    Vec3 m_p, m_q, m_first;
    int m_axis = 0;  // along which the first point is not seen on the line
};

}  // namespace rubble
