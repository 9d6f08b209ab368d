#pragma once

#include "core/play/state/SessionState.h"

namespace rubble {

/// Sets off an explosion: bodies that get at least their threshold are swapped for their fragments, then all bodies get
/// the impulses of one blast: fragments instead of the bodies that they replace. See World::blast().
///
/// Errors: those of World::applyImpulse().
Status applyBlast(const SessionParts& parts, const Explosion& explosion);

}  // namespace rubble
