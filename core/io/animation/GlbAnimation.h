#pragma once

#include "core/io/animation/AnimatedScene.h"

namespace rubble {

/// Returns a scene as a binary glTF 2.0 file with one animation, "simulation": a node for each solid, whose translation
/// and rotation are interpolated evenly, and whose scale steps: 0 while it is not there. See docs/formats/animation.md.
///
/// Errors: Limit above 4 GiB, the maximum of the format.
Result<std::string> glbAnimation(const AnimatedScene& scene);

}  // namespace rubble
