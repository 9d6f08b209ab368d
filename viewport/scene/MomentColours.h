#pragma once

#include "core/play/Session.h"
#include "viewport/scene/PlayOverlays.h"
#include "viewport/scene/RenderScene.h"

#include <span>

namespace rubble {

/// The colour of how near a body is to breaking: from dark blue at 0 over green to yellow just below 1, evenly lighter; at
/// 1 and above a signal red, which is in none of them.
Colour heatColour(double value);

/// What a body of a session is coloured by.
struct BodyTint {
    std::uint32_t body = 0;    // in the scene
    std::uint32_t number = 0;  // in the session
    BodyId id;
    bool isAsleep = false;
};

/// Colours bodies of a scene by islands or heat, and what sleeps blue, as the overlays say. `heat`: ascending number; who is
/// not in it has none. Without islands and heat what is awake keeps its colour.
void tintBodies(RenderScene& scene, std::span<const BodyTint> bodies, const Session& session,
                const PlayOverlays& overlays, std::span<const BodyHeat> heat);

}  // namespace rubble
