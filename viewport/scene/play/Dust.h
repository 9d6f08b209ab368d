#pragma once

#include "core/play/state/EventRecord.h"
#include "viewport/scene/RenderScene.h"

#include <span>

namespace rubble {

/// The moment that is shown.
struct DustMoment {
    std::uint64_t step = 0;
    double stepLength = 1.0 / 60.0;  // s
    Vec3 gravity{0.0, 0.0, 0.0};     // m/s²
};

inline constexpr double kDustTime = 1.0;  // s: what flies after an event is gone then

/// Adds the particles that fly after impacts and breaks to a scene, from nothing but the events and the materials that
/// they name: brittle materials are ground to dust and chips, transparent ones and wood splinter, metals make sparks.
/// The stronger the event, the more of them, in proportion to the cube root of its energy. Of `events`, by ascending
/// step, those after the moment and those older than kDustTime are ignored; the oldest where there are too many. The
/// same events give the same particles. Purely visual.
void addDust(RenderScene& scene, const Project& project, std::span<const EventRecord> events, const DustMoment& moment);

}  // namespace rubble
