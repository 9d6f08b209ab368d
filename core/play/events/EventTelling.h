#pragma once

#include "core/play/state/SessionState.h"

#include <vector>

namespace rubble {

/// The impacts, breaks and bodies that came to rest in an interval of a step, just solved: without the step and the
/// names of fragments. Two bodies that touch are one impact until they have been apart for 0.1 s; the energy of what
/// they do meanwhile counts as that of bodies at rest.
std::vector<EventRecord> happenedEvents(const SessionParts& parts);

/// Sets the report of a step: of what happened and the bodies that were removed, the strongest of each kind, up to
/// EventSettings::maxRecords; counts and sums of the rest.
void tellEvents(const SessionParts& parts, std::vector<EventRecord> happened);

}  // namespace rubble
