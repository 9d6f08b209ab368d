#pragma once

#include "core/play/state/SessionState.h"

namespace rubble {

/// Gives the bodies of a state that was read from outside their assets and hulls, and checks everything in it but the
/// bodies' ids. Returns the place of what is wrong and why, as in "bodies[3].fragment is not one that is free";
/// nothing if the state is one of the scene.
std::optional<std::string> completeState(const PlayScene& scene, SessionState& state);

}  // namespace rubble
