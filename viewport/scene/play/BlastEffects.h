#pragma once

#include "core/play/events/EventHistory.h"
#include "viewport/scene/play/DustParticles.h"

#include <span>

namespace rubble {

inline constexpr double kBlastTime = 6.5;        // s: what flies after a blast is gone then
inline constexpr std::size_t kMaxBlasts = 12;    // of which the effects are shown, the latest ones
inline constexpr std::size_t kMaxScorches = 16;  // on the ground, of the latest blasts

/// Adds what is seen of blasts to a scene, from nothing but their places, radii and ages: a flash and its light on what
/// is around, smoke, a ring and dust that run along the ground where it is within the radius, and soot, which stays. Of
/// `blasts`, by ascending step, those after the moment are ignored. Purely visual.
void addBlasts(RenderScene& scene, std::span<const BlastRecord> blasts, const DustMoment& moment);

}  // namespace rubble
