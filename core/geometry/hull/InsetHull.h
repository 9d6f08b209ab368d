#pragma once

#include "core/geometry/hull/Polytope.h"

#include <optional>

namespace rubble {

/// A hull for the collisions of other engines: that of a solid with its faces moved inwards, so that the hulls of
/// solids that touch do not.
struct InsetHull {
    Polytope polytope;
    double inset = 0.0;  // m, >= 0: of each face
    bool operator==(const InsetHull&) const = default;
};

/// The default inset of the hulls in exports, m. Rapier lets fragments rest from 10 µm on, PhysX and Havok from 50 µm
/// on; other engines need as much as twice their margin.
inline constexpr double kDefaultInset = 1e-4;

/// The most that faces are moved, relative to the thinnestWidth().
inline constexpr double kMaxInset = 0.01;

/// Whether a polytope has the vertices and faces of extruded(), in its order; each face may start at any vertex.
bool isPrism(const Polytope& polytope);

/// The smallest width of a prism, m, in O(n) in its corners; of another polytope, its least extent across a face.
/// Source: the rotating calipers of Shamos 1978, "Computational Geometry".
double thinnestWidth(const Polytope& hull);

/// A hull with its faces moved inwards by `distance` m >= 0, at most kMaxInset of its thinnestWidth(). Faces between
/// which no room is left vanish. The hull itself where rounding leaves nothing. One that is not a prism has at most
/// kMaxCollisionCorners corners, or as many as before: corners that moving faces split are simplified.
InsetHull insetHull(const Polytope& hull, double distance);

/// The hull whose insetHull() this is: exactly, up to rounding, but for faces that vanished, beside which it extends up
/// to some insets further. Nothing if its faces bound no hull.
std::optional<Polytope> solidOf(const InsetHull& hull);

}  // namespace rubble
