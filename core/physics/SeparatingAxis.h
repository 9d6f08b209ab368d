#pragma once

#include "core/physics/Hull.h"

#include <cstdint>

namespace rubble {

/// A hull as it stands in the other's frame.
struct RelativePlace {
    Mat3f turn;                      // first hull's frame from second's
    Vec3f offset{0.0f, 0.0f, 0.0f};  // where the second's centre of mass is in the first's frame
};

enum class AxisKind : std::uint8_t {
    None,
    FirstFace,   // normal of a face of the first hull
    SecondFace,  // of the second
    Edges,       // square to an edge of each
};

/// The direction along which two hulls are farthest apart, or overlap least.
struct SeparatingAxis {
    AxisKind kind = AxisKind::None;
    std::uint16_t first = 0;         // face or edge of the first hull, where the kind has one
    std::uint16_t second = 0;        // of the second
    float separation = -1e30f;       // m
    Vec3f normal{0.0f, 1.0f, 0.0f};  // from first to second, in the first's frame

    bool isFace() const { return kind == AxisKind::FirstFace || kind == AxisKind::SecondFace; }
};

/// How much better an edge must be than a face, or the second hull's face than the first's, m.
inline constexpr float kAxisPreference = 0.0005f;

/// Looks at every face of both and every pair of edges whose faces cross on the sphere of normals. Ends early with an axis along
/// which they are farther apart than `margin`. Faces are preferred to edges, and the first hull's to the second's, where they
/// differ by less than kAxisPreference. `guess` is the axis that was found before, and is looked at first.
///
/// Source: Gregorius 2013, "The separating axis test between convex polyhedra".
SeparatingAxis separatingAxis(const Hull& first, const Hull& second, const RelativePlace& place, float margin,
                              const SeparatingAxis& guess);

/// The first half of separatingAxis(): the best face.
SeparatingAxis bestFaceAxis(const Hull& first, const Hull& second, const RelativePlace& place, float margin,
                            const SeparatingAxis& guess);
/// The second: the best pair of edges where it is clearly better than the best face, which is given; else that face.
SeparatingAxis bestEdgesOr(const SeparatingAxis& face, const Hull& first, const Hull& second,
                           const RelativePlace& place, float margin);

/// The axis of a face, of either hull, as the hulls stand.
SeparatingAxis axisOfFace(const SeparatingAxis& face, const Hull& first, const Hull& second,
                          const RelativePlace& place);

/// The first hull's face that looks along the side on which the hulls' boxes are farthest apart: where to begin with hulls that were
/// never looked at. None where the boxes overlap clearly in every direction: then what parts the hulls leans across them.
SeparatingAxis likelyFace(const Hull& first, const Hull& second, const RelativePlace& place);

/// When two hulls that move without turning begin to touch: `way` is how far the second moves against the first, in the first's
/// frame. The share of the way in [0, 1], and the axis along which they meet; kind None where they do not.
/// Source: Eberly 2001, "Dynamic collision detection".
struct SweptTouch {
    SeparatingAxis axis;
    float share = 1.0f;
};
SweptTouch sweptTouch(const Hull& first, const Hull& second, const RelativePlace& place, Vec3f way);

}  // namespace rubble
