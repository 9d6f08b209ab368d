#pragma once

#include "core/physics/shape/Hull.h"

#include <cstdint>

namespace rubble {

/// The pose of a second hull in the first's frame.
struct RelativePose {
    Mat3f rotation;                  // first from second
    Vec3f offset{0.0f, 0.0f, 0.0f};  // m: the second's centre of mass in the first's frame
};

enum class AxisKind : std::uint8_t {
    None,
    FirstFace,   // the normal of a face of the first hull
    SecondFace,  // the normal of a face of the second hull
    Edges,       // the cross product of an edge of each
};

/// The axis along which two hulls are farthest apart, or overlap least.
struct SeparatingAxis {
    AxisKind kind = AxisKind::None;
    std::uint16_t first = 0;         // index of the first hull's face or edge, if the kind has one
    std::uint16_t second = 0;        // index of the second hull's face or edge
    float separation = -1e30f;       // m
    Vec3f normal{0.0f, 1.0f, 0.0f};  // from first to second, in the first's frame

    bool isFace() const { return kind == AxisKind::FirstFace || kind == AxisKind::SecondFace; }
};

/// The margin by which an edge pair must separate more than a face, or a face of the second hull more than one of the
/// first, m.
inline constexpr float kAxisPreference = 0.0005f;
/// The overlap up to which hulls only touch, m: what rounding to single precision leaves of a common face.
inline constexpr float kTouchingOverlap = 3e-6f;

/// The separating axis test over all face normals of both hulls and all edge pairs that form a face of the Minkowski
/// difference, by their arcs on the Gauss map. Returns early with an axis along which the hulls are more than `margin`
/// apart. Prefers faces to edges and the first hull's faces to the second's, by kAxisPreference, unless hulls overlap
/// along the preferred axis and only touch along the other. `guess`, the axis of
/// the last test, is tested first.
///
/// Source: Gregorius 2013, "The separating axis test between convex polyhedra".
SeparatingAxis separatingAxis(const Hull& first, const Hull& second, const RelativePose& pose, float margin,
                              const SeparatingAxis& guess);

/// The first half of separatingAxis(): the best face of either hull.
SeparatingAxis bestFaceAxis(const Hull& first, const Hull& second, const RelativePose& pose, float margin,
                            const SeparatingAxis& guess);
/// The second half of separatingAxis(): the best edge pair if it is better than `face` by `preference`, m, otherwise
/// `face`.
SeparatingAxis bestEdgeAxis(const SeparatingAxis& face, const Hull& first, const Hull& second, const RelativePose& pose,
                            float margin, float preference = kAxisPreference);

/// The axis of a given face of either hull, its separation computed for `pose`.
SeparatingAxis faceAxis(const SeparatingAxis& face, const Hull& first, const Hull& second, const RelativePose& pose);

/// An initial guess for hulls that have not been tested yet: the first hull's face along the axis on which the bounding
/// boxes are farthest apart. None if the boxes clearly overlap on every axis: no face normal near an axis then
/// separates the hulls.
SeparatingAxis initialGuess(const Hull& first, const Hull& second, const RelativePose& pose);

}  // namespace rubble
