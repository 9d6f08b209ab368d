#pragma once

#include "core/physics/state/BodyDefinition.h"

#include <optional>
#include <string>
#include <string_view>

namespace rubble {

/// Largest deviation of an orientation's length from 1; files may have four digits.
inline constexpr double kUnitTolerance = 1e-3;

/// Whether every coordinate's magnitude is at most `most`; false for NaN.
bool isWithin(Vec3 v, double most);

/// Why a pose is invalid, as a sentence that names its owner `what`; nothing for a valid one.
std::optional<std::string> verifyPose(const Pose& pose, std::string_view what);

/// Why an impulse, N·s, at a point in the world cannot be applied, as a sentence; nothing for one that can.
std::optional<std::string> verifyImpulse(Vec3 impulse, Vec3 point);

/// Why a material is invalid, as a sentence; nothing for a valid one. The mass properties of a dynamic body of this
/// shape must be within single precision.
std::optional<std::string> verifyMaterial(const BodyMaterial& material, const Shape& shape, BodyKind kind);

/// Why a body cannot be created from a definition, as a sentence; nothing for a valid one.
std::optional<std::string> verifyBodyDefinition(const BodyDefinition& definition);

}  // namespace rubble
