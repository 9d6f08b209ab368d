#pragma once

#include "core/play/session/Session.h"
#include "viewport/scene/RenderScene.h"
#include "viewport/scene/play/PlayOverlays.h"

#include <span>

namespace rubble {

/// The heat colour of an impact ÷ threshold: from dark blue at 0 over green to yellow just below 1, with rising
/// lightness; at 1 and above a signal red that the ramp does not contain.
Colour heatColour(double value);

/// The properties of a body that tintBodies() needs.
struct BodyTint {
    std::uint32_t body = 0;    // in the scene
    std::uint32_t number = 0;  // in the session
    BodyId id;
    bool isAsleep = false;
    std::uint32_t fragment = kNone;  // of its asset's bake; kNone: the whole
};

/// Colours the bodies of a scene by number, island or heat, and sleeping ones blue, as the overlays say. `heat`: by
/// ascending number; missing bodies have none. Without any of these, awake bodies keep their colours. `collapse`, if
/// there is one: its bodies in signal colours, all others paler.
void tintBodies(RenderScene& scene, std::span<const BodyTint> bodies, const Session& session,
                const PlayOverlays& overlays, std::span<const BodyHeat> heat, const BodyCollapse* collapse = nullptr);

}  // namespace rubble
