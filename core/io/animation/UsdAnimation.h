#pragma once

#include "core/io/animation/AnimatedScene.h"

namespace rubble {

/// Returns a scene as a USD text layer (.usda) with time samples: y up, metres; a time code is a frame. Each solid is
/// an Xform with a Mesh, invisible while it is not there. `imageFiles`: the names of the scene's images beside the
/// layer. See docs/formats/animation.md.
std::string usdAnimation(const AnimatedScene& scene, std::span<const std::string> imageFiles);

}  // namespace rubble
