#pragma once

#include "core/play/state/SessionState.h"

#include <vector>

namespace rubble {

/// The impacts, breaks and bodies that came to rest in an interval of a step, just solved: without the step and the
/// names of fragments. Two bodies that touch are one impact until they have been apart for 0.1 s; the energy of what
/// they do meanwhile counts as that of bodies at rest.
std::vector<EventRecord> happenedEvents(SessionParts& parts);

/// Adds the bodies that were removed to what happened in a step, and sets its report: the strongest of each kind, up to
/// EventSettings::maxRecords; counts and sums of the rest. Impacts below the least energy are only counted.
void tellEvents(SessionParts& parts);

}  // namespace rubble
