#pragma once

#include "core/play/scene/PlayMortar.h"
#include "viewport/scene/RenderScene.h"

#include <array>
#include <span>

namespace rubble {

/// The corners of the rectangle that has the area and the second moments of a joint's face, m, in the world. A joint
/// without moments has none: all corners are its centroid.
std::array<Vec3, 4> jointCorners(const MortarJoint& joint);

/// Adds the outlines of the faces at which mortar joins instances, as jointCorners().
void addJointLines(RenderScene& scene, std::span<const MortarJoint> joints);

}  // namespace rubble
