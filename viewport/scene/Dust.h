#pragma once

#include "core/play/session/Session.h"
#include "viewport/scene/RenderScene.h"

namespace rubble {

/// Adds the dust and splinters of a session's recent breaks to its scene. They start at the cuts between the solids and
/// drift away from the point of impact. Dust has the colour of the material, grows, and fades within about 0.6 s; glass
/// makes splinters instead, which fall and glint, tough materials hardly any of both. Deterministic; purely visual.
void addDust(RenderScene& scene, const Session& session);

}  // namespace rubble
