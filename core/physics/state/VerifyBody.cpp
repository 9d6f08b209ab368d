#include "core/physics/state/VerifyBody.h"

#include <cmath>

namespace rubble {
namespace {

constexpr double kUnitTolerance = 1e-3;  // of a rotation's length: it is made a unit

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

std::optional<std::string> verifyBodyDefinition(const BodyDefinition& definition) {
    const auto isNegative = [](double value) { return !(value >= 0.0 && std::isfinite(value)); };
    if (definition.shape == nullptr) return "A body needs a shape.";
    if (const auto fault = verifyPose(definition.pose, "a body")) return fault;
    if (!isWithin(definition.velocity, kMaxSpeed)) return "The velocity of a body must be below 10 km/s.";
    if (!isWithin(definition.angularVelocity, kMaxSpeed))
        return "The angular velocity of a body must be below 10,000 rad/s.";
    if (!(definition.density > 0.0 && std::isfinite(definition.density)))
        return "The density of a body must be positive.";
    if (isNegative(definition.friction)) return "The friction of a body must not be negative.";
    if (!(definition.restitution >= 0.0 && definition.restitution <= 1.0)) {
        return "The restitution of a body must lie between 0 and 1.";
    }
    if (isNegative(definition.linearDamping) || isNegative(definition.angularDamping)) {
        return "The damping of a body must not be negative.";
    }
    return std::nullopt;
}

}  // namespace rubble
