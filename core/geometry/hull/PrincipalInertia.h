#pragma once

#include "core/geometry/predicates/Vec.h"

namespace rubble {

/// An inertia as engines take it: moments along three axes, and the frame of these axes.
struct PrincipalInertia {
    Vec3 moments{0.0};                  // descending; in the unit of the tensor
    Quat rotation{1.0, 0.0, 0.0, 0.0};  // of the principal frame in the body's: w >= 0
    bool operator==(const PrincipalInertia&) const = default;
};

/// Diagonalizes a symmetric tensor: tensor = R diag(moments) Rᵀ with the matrix R of the rotation. Equal tensors have
/// the same bits everywhere: of the first two axes, the component of largest magnitude (the first of those within 1e-9
/// of it) is positive, and the third is their cross product. Elements beside the diagonal that are rounding are
/// ignored, and equal moments stay in the order of the body's axes.
/// Source: Golub, van Loan, Matrix Computations, 4th edition, 2013, 8.5 (Jacobi's method).
PrincipalInertia principalInertia(const Mat3& tensor);

/// The tensor with these moments along the axes of the rotation.
Mat3 tensorOf(const PrincipalInertia& inertia);

}  // namespace rubble
