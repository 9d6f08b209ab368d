#pragma once

#include "core/geometry/hull/Polytope.h"

#include <optional>
#include <span>

namespace rubble {

/// Where faces of two solids lie against each other. Kept as integrals, so that contacts can be summed.
struct FaceContact {
    double area = 0.0;   // m²
    Vec3 centroid{0.0};  // m, halfway between the faces
    Vec3 normal{0.0};    // of length 1, out of the first
    Mat3 moments{0.0};   // m⁴: the integral of r rᵀ over the common area, r from the centroid
};

/// The largest angle between a face and the opposite of another that it lies against: 1 degree, as its cosine.
inline constexpr double kMinFacing = 0.99984769515639124;

/// The contact of two convex polytopes in one frame: the sum over all pairs of faces that lie against each other. Two
/// faces do if their normals are opposite within 1 degree and they overlap when projected on the plane between them;
/// and if there, at the centroid of the overlap, they are at most `tolerance` (m, >= 0) apart. They may overlap as much
/// in depth, up to half of either polytope, so that the far sides of thin plates do not count.
///
/// Nothing if the area is below `leastArea` (m²) or zero. Swapping the polytopes gives the opposite normal, all else
/// the same up to rounding. O(faces of the first * faces of the second), little for pairs that do not face each other.
std::optional<FaceContact> faceContact(const Polytope& first, const Polytope& second, double tolerance,
                                       double leastArea);

/// Several contacts of the same two solids as one: areas are summed, the normal is the area-weighted mean, or the first
/// contact's where that vanishes. Nothing if there are none.
std::optional<FaceContact> combinedContact(std::span<const FaceContact> contacts);

}  // namespace rubble
