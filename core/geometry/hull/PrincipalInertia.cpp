#include "core/geometry/hull/PrincipalInertia.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rubble {
namespace {

constexpr double kRounding = 1e-15;    // of the largest element: what is smaller beside the diagonal is none
constexpr int kMaxSweeps = 30;         // Jacobi's method takes about six
constexpr double kEqualMoment = 1e-9;  // relative
constexpr double kEqualSize = 1e-9;    // of components of an axis

/// A symmetric tensor on its way to a diagonal one, and the axes found so far as columns.
struct JacobiState {
    Mat3 tensor;
    Mat3 axes{1.0};
};

double largestElement(const Mat3& matrix) {
    double largest = 0.0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(matrix[column][row]));
    return largest;
}

/// Rotates the plane of two axes so that the element of both vanishes.
void annihilate(JacobiState& state, int p, int q) {
    const double between = state.tensor[q][p];
    const double theta = (state.tensor[q][q] - state.tensor[p][p]) / (2.0 * between);
    const double tangent = (theta < 0.0 ? -1.0 : 1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
    const double cosine = 1.0 / std::sqrt(tangent * tangent + 1.0), sine = tangent * cosine;
    Mat3 rotation(1.0);
    rotation[p][p] = rotation[q][q] = cosine;
    rotation[q][p] = sine;
    rotation[p][q] = -sine;
    state.tensor = glm::transpose(rotation) * state.tensor * rotation;
    state.tensor[p][q] = state.tensor[q][p] = 0.0;
    state.axes = state.axes * rotation;
}

JacobiState diagonalized(const Mat3& tensor) {
    JacobiState state{.tensor = tensor};
    const double rounding = kRounding * largestElement(tensor);
    constexpr std::array<std::array<int, 2>, 3> kPairs{{{0, 1}, {0, 2}, {1, 2}}};
    for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
        bool isDiagonal = true;
        for (const auto& [p, q] : kPairs) {
            if (std::abs(state.tensor[q][p]) <= rounding) continue;
            annihilate(state, p, q);
            isDiagonal = false;
        }
        if (isDiagonal) break;
    }
    return state;
}

/// The axis or its opposite, whichever has the largest component positive.
Vec3 withFixedSign(Vec3 axis) {
    double largest = 0.0;
    for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(axis[k]));
    for (int k = 0; k < 3; ++k) {
        if (std::abs(axis[k]) >= largest * (1.0 - kEqualSize)) return axis[k] < 0.0 ? -axis : axis;
    }
    return axis;
}

}  // namespace

PrincipalInertia principalInertia(const Mat3& tensor) {
    const JacobiState state = diagonalized(tensor);
    std::array<int, 3> order{0, 1, 2};
    const double equal = kEqualMoment * largestElement(tensor);
    // Insertion sort: moments that are equal within a tolerance have no order to sort by.
    for (const int last : {1, 2}) {
        for (int k = last; k > 0; --k) {
            const double before = state.tensor[order[k - 1]][order[k - 1]], after = state.tensor[order[k]][order[k]];
            if (after <= before + equal) break;
            std::swap(order[k - 1], order[k]);
        }
    }
    PrincipalInertia inertia;
    Mat3 axes(1.0);
    for (int k = 0; k < 3; ++k) {
        inertia.moments[k] = state.tensor[order[k]][order[k]];
        axes[k] = withFixedSign(state.axes[order[k]]);
    }
    axes[2] = glm::cross(axes[0], axes[1]);
    inertia.rotation = glm::normalize(glm::quat_cast(axes));
    if (inertia.rotation.w < 0.0) inertia.rotation = -inertia.rotation;
    return inertia;
}

Mat3 tensorOf(const PrincipalInertia& inertia) {
    const Mat3 axes = glm::mat3_cast(inertia.rotation);
    Mat3 diagonal(0.0);
    for (int k = 0; k < 3; ++k) diagonal[k][k] = inertia.moments[k];
    return axes * diagonal * glm::transpose(axes);
}

}  // namespace rubble
