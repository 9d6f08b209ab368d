#include "core/physics/state/VerifyBody.h"

#include "core/base/MessageText.h"

#include <cmath>

namespace rubble {
namespace {

/// Mass properties of single precision, with room for the sums and products of a solver step.
constexpr double kMinMagnitude = 1e-37, kMaxMagnitude = 1e37;

bool isRepresentable(double value) { return value >= kMinMagnitude && value <= kMaxMagnitude; }

bool hasRepresentableMass(const Shape& shape, double density) {
    if (!isRepresentable(shape.mass.volume * density)) return false;
    for (int k = 0; k < 3; ++k) {
        if (!isRepresentable(shape.inertia[k][k] * density)) return false;
        if (!isRepresentable(shape.inverseInertia[k][k] / density)) return false;
    }
    return true;
}

bool isNegative(double value) { return !(value >= 0.0 && std::isfinite(value)); }

}  // namespace

bool isWithin(Vec3 v, double most) {
    return std::abs(v.x) <= most && std::abs(v.y) <= most && std::abs(v.z) <= most;  // false for nan
}

std::optional<std::string> verifyPose(const Pose& pose, std::string_view what) {
    if (!isWithin(pose.position, kMaxCoordinate)) {
        return "The position of " + std::string(what) + " must be within 100 km of the origin.";
    }
    const Quat& rotation = pose.orientation;
    const double size = std::sqrt(rotation.x * rotation.x + rotation.y * rotation.y + rotation.z * rotation.z +
                                  rotation.w * rotation.w);
    if (!(std::abs(size - 1.0) <= kUnitTolerance)) {
        return "The orientation of " + std::string(what) + " must be a quaternion of length 1.";
    }
    return std::nullopt;
}

std::optional<std::string> verifyImpulse(Vec3 impulse, Vec3 point) {
    const auto limit = [](const char* what, double most, const char* unit) {
        return std::string(what) + " must be finite and at most " + messageText(most) + " " + unit +
               " along each axis.";
    };
    if (!isWithin(impulse, kMaxImpulse)) return limit("An impulse", kMaxImpulse, "N·s");
    if (!isWithin(point, kMaxCoordinate)) return limit("A place", kMaxCoordinate, "m");
    return std::nullopt;
}

std::optional<std::string> verifyMaterial(const BodyMaterial& material, const Shape& shape, BodyKind kind) {
    if (!(material.density > 0.0 && std::isfinite(material.density))) return "The density of a body must be positive.";
    if (isNegative(material.friction)) return "The friction of a body must not be negative.";
    if (!(material.restitution >= 0.0 && material.restitution <= 1.0)) {
        return "The restitution of a body must lie between 0 and 1.";
    }
    if (kind != BodyKind::Dynamic || hasRepresentableMass(shape, material.density)) return std::nullopt;
    return "The mass of a body is " + messageText(shape.mass.volume * material.density) +
           " kg; it or its inertia is too small or too large for single precision.";
}

std::optional<std::string> verifyBodyDefinition(const BodyDefinition& definition) {
    if (definition.shape == nullptr) return "A body needs a shape.";
    if (const auto fault = verifyPose(definition.pose, "a body")) return fault;
    if (!isWithin(definition.velocity, kMaxSpeed)) return "The velocity of a body must be below 10 km/s.";
    if (!isWithin(definition.angularVelocity, kMaxSpeed))
        return "The angular velocity of a body must be below 10,000 rad/s.";
    if (auto fault = verifyMaterial(definition.material(), *definition.shape, definition.kind)) return fault;
    if (isNegative(definition.linearDamping) || isNegative(definition.angularDamping)) {
        return "The damping of a body must not be negative.";
    }
    return std::nullopt;
}

}  // namespace rubble
