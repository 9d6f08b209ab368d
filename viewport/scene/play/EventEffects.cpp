#include "viewport/scene/play/EventEffects.h"

#include "viewport/scene/play/BlastEffects.h"
#include "viewport/scene/play/Chips.h"

#include <algorithm>

namespace rubble {
namespace {

/// The first step of which something may still be seen.
std::uint64_t firstShown(std::uint64_t step, double stepLength) {
    return step - std::min(step, stepOf(std::max({kDustTime, kDebrisTime, kBlastTime}), stepLength));
}

}  // namespace

bool hasEventEffects(const EventHistory& history, std::uint64_t step, double stepLength) {
    const std::uint64_t first = firstShown(step, stepLength);
    return !history.between(first, step).empty() || !history.blastsBetween(first, step).empty();
}

void addEventEffects(RenderScene& scene, const Project& project, const EventHistory& history,
                     const DustMoment& moment) {
    const auto events = history.between(firstShown(moment.step, moment.stepLength), moment.step);
    addDust(scene, project, events, moment);
    addDebris(scene, project, events, moment);
    addBlasts(scene, history.blastsBetween(0, moment.step), moment);
}

}  // namespace rubble
