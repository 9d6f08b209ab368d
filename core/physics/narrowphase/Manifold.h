#pragma once

#include "core/physics/narrowphase/SeparatingAxis.h"

#include <array>

namespace rubble {

inline constexpr int kMaxManifoldPoints = 4;

/// The contact points of two hulls that touch or nearly do, in the first hull's frame.
struct Manifold {
    struct Point {
        Vec3f position{0.0f, 0.0f, 0.0f};  // m, halfway between the hulls
        float separation = 0.0f;           // m, negative where they overlap
        std::uint32_t feature = 0;         // identifies the corner or edges that generate the point
    };
    Vec3f normal{0.0f, 1.0f, 0.0f};  // from first to second, length 1
    int count = 0;
    std::array<Point, kMaxManifoldPoints> points;
};

/// The contact points along an axis with a separation of at most `margin`. For a face: the incident face of the other
/// hull clipped to it and reduced to four points: the deepest, and three that span a large area with it. For edges: the
/// same of the two faces that are most along the axis, if one is within 37 degrees of it; else the point between the
/// edges, none if the closest points of their lines lie beyond their ends.
/// Source: Gregorius 2015, "Robust contact creation"; faces for edges as in Rouwe's Jolt Physics.
///
/// `turn`: what the second will turn by relative to the first, as a rotation vector in the first's frame, rad. A hull
/// of many faces rolls on to the one that is most opposed after that.
Manifold manifoldAlong(const SeparatingAxis& axis, const Hull& first, const Hull& second, const RelativePose& pose,
                       float margin, Vec3f turn = Vec3f(0.0f));

/// The supporting corner along an axis: the first hull's if it touches a face of the second, else the second's; with no
/// separation.
Manifold::Point supportingCorner(const SeparatingAxis& axis, const Hull& first, const Hull& second,
                                 const RelativePose& pose);

/// Whether a point is as deep as hulls of a separation, to half a millimetre.
bool isReached(const Manifold& manifold, float separation);

/// The same as manifoldAlong() for hulls known to touch along the axis: if clipping leaves no point, the supporting
/// corner, with no separation.
Manifold touchingManifold(const SeparatingAxis& axis, const Hull& first, const Hull& second, const RelativePose& pose,
                          float margin);

}  // namespace rubble
