#pragma once

#include "core/play/session/Session.h"
#include "viewport/scene/RenderScene.h"
#include "viewport/scene/play/PlayOverlays.h"

namespace rubble {

/// The length scale of arrows, m: a third of the mean size of the scene's assets; 1 if there are none.
double arrowScale(const PlayScene& scene);

/// The length of an impulse's arrow, m: it grows with the square root of the impulse of a sub-step, N·s, and equals
/// `scale` at 100 N·s (1 t at 0.1 m/s); clamped to [0.1, 4] × `scale`, so that it is visible and does not hide the
/// scene.
double impulseLength(double impulse, double scale);

/// Adds the contact points, normals and impulses of a session to its scene, as the overlays say. Linear in contacts.
void addContactLines(RenderScene& scene, const Session& session, const PlayOverlays& overlays, double scale);

/// Adds the broad-phase box of a body, which moves with it. `body`: its index in the scene.
void addBodyBox(RenderScene& scene, const Box3& box, std::uint32_t body);

}  // namespace rubble
