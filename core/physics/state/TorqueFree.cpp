#include "core/physics/state/TorqueFree.h"

#include <cmath>

namespace rubble {
namespace {

constexpr float kMaxAngle = 0.5f;  // rad per step of the integrator: Newton's method converges in three rounds
constexpr int kMaxSteps = 32;      // 16 rad: in a step of 1/60 s, 150 revolutions a second
constexpr int kNewtonRounds = 4;
constexpr float kPrecision = 1e-3f;  // relative: Newton's method squares the error, so the next correction is rounding
constexpr float kMaxCorrection = 1e-2f;  // relative: of the last round of a solution

/// A 3 x 3 matrix by columns.
struct Columns {
    Vec3f x, y, z;
};

/// The solution of m v = right by Cramer's rule; zero for a singular matrix.
Vec3f solved(const Columns& m, Vec3f right) {
    const Vec3f yz = cross(m.y, m.z);
    const float determinant = dot(m.x, yz);
    if (determinant == 0.0f) return Vec3f(0.0f);
    return Vec3f(dot(right, yz), dot(m.x, cross(right, m.z)), dot(m.x, cross(m.y, right))) * (1.0f / determinant);
}

/// The derivative of I (W - w) + h/2 W x I W by W, along an axis.
Vec3f derivativeAlong(Vec3f axis, const SymMat3f& inertia, Vec3f mean, Vec3f momentum, float half) {
    const Vec3f change = inertia * axis;
    return change + (cross(axis, momentum) + cross(mean, change)) * half;
}

/// The rotation by cay(h w), for half = h / 2.
Quatf cayley(Vec3f w, float half) { return Quatf{w.x * half, w.y * half, w.z * half, 1.0f}.normalized(); }

/// Rotates about the angular momentum, which leaves it and the angular velocity as they are in the body's axes.
TorqueFreeMotion rotatedAboutMomentum(const Body& body, const TorqueFreeMotion& motion, float h) {
    const Vec3f axis = normalized(body.inertia * motion.angularVelocity);
    const Quatf rotation = cayley(axis * dot(motion.angularVelocity, axis), 0.5f * h);
    return {(motion.rotation * rotation).normalized(), motion.angularVelocity};
}

}  // namespace

std::optional<Vec3f> meanAngularVelocity(const Body& body, Vec3f w, float h) {
    const SymMat3f& inertia = body.inertia;
    const float half = 0.5f * h, size = lengthSquared(w);
    if (size * h * h > 1.01f * kMaxAngle * kMaxAngle) return std::nullopt;
    // One round of the fixed-point iteration is nearer than w.
    Vec3f mean = w - body.inverseInertia * cross(w, inertia * w) * half;
    float correction = size;
    for (int round = 0; round < kNewtonRounds && correction > kPrecision * kPrecision * size; ++round) {
        const Vec3f momentum = inertia * mean;
        const Vec3f residual = inertia * (mean - w) + cross(mean, momentum) * half;
        const Columns jacobian{derivativeAlong(Vec3f(1.0f, 0.0f, 0.0f), inertia, mean, momentum, half),
                               derivativeAlong(Vec3f(0.0f, 1.0f, 0.0f), inertia, mean, momentum, half),
                               derivativeAlong(Vec3f(0.0f, 0.0f, 1.0f), inertia, mean, momentum, half)};
        const Vec3f change = solved(jacobian, residual);
        mean -= change;
        correction = lengthSquared(change);
    }
    if (!(correction <= kMaxCorrection * kMaxCorrection * size)) return std::nullopt;
    return mean;
}

TorqueFreeMotion advanced(const Body& body, TorqueFreeMotion motion, float h) {
    const float angle = length(motion.angularVelocity) * h;
    const int steps = angle < kMaxAngle * kMaxSteps ? 1 + static_cast<int>(angle / kMaxAngle) : 0;
    const float part = steps > 0 ? h / static_cast<float>(steps) : 0.0f;
    for (int step = 0; step < steps; ++step) {
        const std::optional<Vec3f> mean = meanAngularVelocity(body, motion.angularVelocity, part);
        if (!mean) return rotatedAboutMomentum(body, motion, h - part * static_cast<float>(step));
        motion.rotation = (motion.rotation * cayley(*mean, 0.5f * part)).normalized();
        motion.angularVelocity = *mean * 2.0f - motion.angularVelocity;
    }
    return steps > 0 ? motion : rotatedAboutMomentum(body, motion, h);
}

}  // namespace rubble
