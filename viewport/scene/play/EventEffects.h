#pragma once

#include "core/play/events/EventHistory.h"
#include "viewport/scene/play/Dust.h"

namespace rubble {

/// Whether events of a history are still seen at a step.
bool hasEventEffects(const EventHistory& history, std::uint64_t step, double stepLength);

/// Adds what is seen of the events of a history for a while: dust, chips and blasts.
void addEventEffects(RenderScene& scene, const Project& project, const EventHistory& history, const DustMoment& moment);

}  // namespace rubble
