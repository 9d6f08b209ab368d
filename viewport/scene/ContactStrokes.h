#pragma once

#include "core/play/Session.h"
#include "viewport/scene/PlayOverlays.h"
#include "viewport/scene/RenderScene.h"

namespace rubble {

/// How long arrows are in a scene: a third of what its instances measure in the mean, m; 1 where there are none.
double arrowScale(const PlayScene& scene);

/// The length of an impulse's arrow, m: it grows with the root of the impulse of a sub-step, N s, and is `scale` long where that
/// stops a tonne at 0.1 m/s; from a tenth of that to four times as much, so that it is seen and does not hide the scene.
double impulseLength(double impulse, double scale);

/// Adds the contacts of a session to a scene that is drawn of it. Linear in contacts.
void addContactStrokes(RenderScene& scene, const Session& session, const PlayOverlays& overlays, double scale);

/// Adds the boxes of the broad phase, but for the ground's. A box goes with its body, whose index in the scene is given.
void addBodyBox(RenderScene& scene, const Box3& box, std::uint32_t body);

}  // namespace rubble
