#include "editor/play/RecordedFrames.h"

#include "core/base/Assert.h"

#include <algorithm>
#include <utility>

namespace rubble {

RecordedFrames::RecordedFrames(std::shared_ptr<const PlayScene> scene, double stepLength, std::size_t maxBytes)
    : m_scenes(scene, stepLength, maxBytes), m_newest{.played = scene} {}

bool RecordedFrames::isKnown(std::uint64_t step) const {
    const std::lock_guard lock(m_mutex);
    return m_scenes.isKnown(step);
}

void RecordedFrames::add(const Step& step, SessionMoment moment, const PlayEvents& events) {
    const std::lock_guard lock(m_mutex);
    if (m_scenes.isKnown(step.step)) return;
    m_scenes.add(step.step, std::move(moment), events);
    m_steps.push_back(step);
}

void RecordedFrames::discardAfter(std::uint64_t step) {
    const std::lock_guard lock(m_mutex);
    m_scenes.discardAfter(step);
    while (!m_steps.empty() && m_steps.back().step > step) m_steps.pop_back();
}

void RecordedFrames::clear() {
    const std::lock_guard lock(m_mutex);
    m_scenes.clear();
    m_steps.clear();
}

/// Of what depends on the state of the session, nothing is kept.
void RecordedFrames::setNewest(const PlayFrame& frame) {
    const std::lock_guard lock(m_mutex);
    m_newest = {.played = frame.played, .length = frame.length, .loop = frame.loop, .branches = frame.branches};
}

std::optional<PlayFrame> RecordedFrames::frameUntil(std::uint64_t step) const {
    const std::lock_guard lock(m_mutex);
    const std::optional<std::uint64_t> last = m_scenes.lastStepUntil(step);
    if (!last) return std::nullopt;
    const auto recorded = std::ranges::lower_bound(m_steps, *last, {}, &Step::step);
    RUBBLE_ASSERT(recorded != m_steps.end() && recorded->step == *last);
    PlayFrame frame = m_newest;
    frame.scene = m_scenes.sceneAt(*last);
    frame.step = *last;
    frame.statistics = recorded->statistics;
    frame.hasDestruction = recorded->hasDestruction;
    frame.isRecorded = true;
    return frame;
}

}  // namespace rubble
