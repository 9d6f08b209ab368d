#pragma once

#include "core/play/state/SessionState.h"

#include <string>

namespace rubble {

/// Sets off a blast: bodies that get at least their threshold are swapped for their fragments, then all bodies get
/// the impulses of one blast: fragments instead of the bodies that they replace. See World::blast(). An impulse that
/// the world does not take is reported, with its body.
void applyBlast(SessionParts& parts, const std::string& name, const Blast& blast);

}  // namespace rubble
