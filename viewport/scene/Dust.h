#pragma once

#include "core/play/session/Session.h"
#include "viewport/scene/RenderScene.h"

namespace rubble {

/// Adds the dust of a session's recent breaks to its scene: puffs that start at the cuts between the pieces, drift away
/// from the point of impact, grow, and fade within about 0.8 s. Deterministic; purely visual.
void addDust(RenderScene& scene, const Session& session);

}  // namespace rubble
