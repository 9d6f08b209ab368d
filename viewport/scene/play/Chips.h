#pragma once

#include "core/play/state/EventRecord.h"
#include "viewport/scene/play/DustParticles.h"

#include <span>

namespace rubble {

inline constexpr double kDebrisTime = 7.0;      // s: chips of an event are gone then
inline constexpr std::size_t kMaxChips = 3000;  // of a scene: where there were more, each event makes fewer

/// Adds the chips that come off in breaks and impacts to a scene, from nothing but the events and the materials that
/// they name. Their number grows with the area that broke and the cube root of the energy, their shapes follow from the
/// material. Of `events`, by ascending step, those after the moment and those older than kDebrisTime are ignored. The
/// same events give the same chips. Purely visual.
///
/// Source: Turcotte, "Fractals and fragmentation", 1986, for the distribution of sizes.
void addDebris(RenderScene& scene, const Project& project, std::span<const EventRecord> events,
               const DustMoment& moment);

}  // namespace rubble
