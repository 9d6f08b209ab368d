#pragma once

#include "core/play/state/EventRecord.h"
#include "viewport/scene/play/DustParticles.h"

#include <span>

namespace rubble {

inline constexpr double kDustTime = 6.5;  // s: the dust and the sparks of an event are gone then

/// Adds the dust and the sparks of impacts and breaks to a scene, from nothing but the events and the materials that
/// they name: minerals are ground to dust, transparent materials and wood hardly, metals make sparks.
/// The stronger the event, the more of them, in proportion to the cube root of its energy; where all together made too
/// many, each makes fewer. Part of the dust lingers near the ground. Of `events`, by ascending step, those after the
/// moment and those older than kDustTime are ignored. The same events give the same particles. Purely visual.
void addDust(RenderScene& scene, const Project& project, std::span<const EventRecord> events, const DustMoment& moment);

}  // namespace rubble
