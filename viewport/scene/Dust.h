#pragma once

#include "core/play/Session.h"
#include "viewport/scene/RenderScene.h"

namespace rubble {

/// Adds the dust that the recent breaks of a session raised, to a scene that is drawn of it: puffs that begin where pieces
/// came apart, drift away from where the whole was hit, grow and fade within about 0.8 s. The same for the same breaks;
/// nothing touches it.
void addDust(RenderScene& scene, const Session& session);

}  // namespace rubble
