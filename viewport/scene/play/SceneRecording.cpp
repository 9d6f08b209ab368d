#include "viewport/scene/play/SceneRecording.h"

#include "core/base/Assert.h"
#include "core/play/session/Session.h"
#include "viewport/scene/play/EventEffects.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace rubble {
namespace {

template <class Value>
std::size_t bytesOf(const std::vector<Value>& values) {
    return values.capacity() * sizeof(Value);
}

std::size_t bytesOf(const RenderScene& layout) {
    std::size_t bytes = sizeof(RenderScene) + bytesOf(layout.batches) + bytesOf(layout.appearances);
    for (const SceneBatch& batch : layout.batches) bytes += bytesOf(batch.firstBodies);
    if (layout.restOffsets) bytes += bytesOf(*layout.restOffsets);
    return bytes + bytesOf(layout.picks);
}

template <class Value>
bool startsWith(const std::vector<Value>& values, const std::vector<Value>& start) {
    return values.size() >= start.size() && std::equal(start.begin(), start.end(), values.begin());
}

/// Whether a layout has all bodies of an earlier one, at the same indices.
bool extends(const RenderScene& layout, const RenderScene& earlier) {
    if (layout.origin != earlier.origin || layout.batches.size() < earlier.batches.size()) return false;
    for (std::size_t k = 0; k < earlier.batches.size(); ++k) {
        SceneBatch batch = layout.batches[k];
        if (!startsWith(batch.firstBodies, earlier.batches[k].firstBodies)) return false;
        batch.firstBodies = earlier.batches[k].firstBodies;
        if (batch != earlier.batches[k]) return false;
    }
    if ((layout.restOffsets == nullptr) != (earlier.restOffsets == nullptr)) return false;
    return (!layout.restOffsets || startsWith(*layout.restOffsets, *earlier.restOffsets)) &&
           startsWith(layout.picks, earlier.picks) && startsWith(layout.appearances, earlier.appearances);
}

/// Sets shared values, null if there are none; whether they are others than before.
template <class Value>
bool update(std::shared_ptr<const std::vector<Value>>& shared, std::vector<Value> values) {
    if (shared ? *shared == values : values.empty()) return false;
    shared = values.empty() ? nullptr : std::make_shared<const std::vector<Value>>(std::move(values));
    return true;
}

}  // namespace

std::size_t SceneRecording::Step::bytes() const {
    const std::size_t own = sizeof(Step) + bytesOf(shown) + bytesOf(hidden);
    return own + (hasOwnLines && lines ? bytesOf(*lines) : 0) + (hasOwnMarks && marks ? bytesOf(*marks) : 0);
}

SceneRecording::SceneRecording(std::shared_ptr<const PlayScene> scene, double stepLength, std::size_t maxBytes)
    : m_scene(std::move(scene)), m_stepLength(stepLength), m_maxBytes(maxBytes) {}

/// The index of a layout. One that extends the last one replaces it: what is added is hidden in the earlier steps.
std::uint32_t SceneRecording::layoutOf(const std::shared_ptr<const RenderScene>& layout) {
    if (m_layouts.empty() || m_layouts.back() != layout) {
        if (!m_layouts.empty() && extends(*layout, *m_layouts.back())) {
            m_layoutBytes -= bytesOf(*m_layouts.back());
            m_layouts.back() = layout;
        } else {
            m_layouts.push_back(layout);
        }
        m_layoutBytes += bytesOf(*layout);
    }
    return static_cast<std::uint32_t>(m_layouts.size() - 1);
}

/// Sets what differs from the last step.
void SceneRecording::setChanges(Step& step, const std::vector<ShownBody>& bodies) const {
    auto before = m_last.begin();
    for (const ShownBody& body : bodies) {
        for (; before != m_last.end() && before->body < body.body; ++before) step.hidden.push_back(before->body);
        const bool isKnown = before != m_last.end() && before->body == body.body;
        if (!isKnown || *before != body) step.shown.push_back(body);
        if (isKnown) ++before;
    }
    for (; before != m_last.end(); ++before) step.hidden.push_back(before->body);
    step.shown.shrink_to_fit();
    step.hidden.shrink_to_fit();
}

void SceneRecording::add(std::uint64_t step, SessionMoment moment, const PlayEvents& events) {
    if (isKnown(step)) return;
    m_events.add(step, events);
    Step added{.step = step, .layout = layoutOf(moment.layout), .gravity = moment.gravity};
    if (!m_steps.empty()) {
        added.lines = m_steps.back().lines;
        added.marks = m_steps.back().marks;
    }
    added.hasOwnLines = update(added.lines, std::move(moment.lines));
    added.hasOwnMarks = update(added.marks, std::move(moment.marks));
    const bool isFollowing = !m_steps.empty() && !m_last.empty() && m_steps.back().layout == added.layout;
    if (isFollowing) setChanges(added, moment.bodies);
    m_changes += 1 + added.shown.size() + added.hidden.size();
    if (!isFollowing || m_changes > moment.bodies.size()) {
        added.isKey = true;
        added.shown = moment.bodies;
        added.hidden = {};
        m_changes = 0;
    }
    m_last = std::move(moment.bodies);
    push(std::move(added));
}

void SceneRecording::push(Step step) {
    m_stepBytes += step.bytes();
    m_steps.push_back(std::move(step));
    while (bytes() > m_maxBytes && m_steps.size() > 2) thin();
}

/// A step without the one before it.
SceneRecording::Step SceneRecording::merged(const Step& earlier, Step later) {
    if (!later.isKey) {
        std::vector<ShownBody> shown;
        std::ranges::set_union(later.shown, earlier.shown, std::back_inserter(shown), {}, &ShownBody::body,
                               &ShownBody::body);  // of both, the first
        std::erase_if(shown, [&](const ShownBody& one) { return std::ranges::binary_search(later.hidden, one.body); });
        std::vector<std::uint32_t> hidden;
        if (!earlier.isKey) {
            std::ranges::set_union(earlier.hidden, later.hidden, std::back_inserter(hidden));
            std::erase_if(hidden, [&](std::uint32_t body) {
                return std::ranges::binary_search(later.shown, body, {}, &ShownBody::body);
            });
        }
        shown.shrink_to_fit();
        hidden.shrink_to_fit();
        later.shown = std::move(shown);
        later.hidden = std::move(hidden);
        later.isKey = earlier.isKey;
    }
    later.hasOwnLines |= earlier.hasOwnLines;
    later.hasOwnMarks |= earlier.hasOwnMarks;
    return later;
}

/// Forgets every second one of the older steps, which need half of the memory, where they are the densest, and one at
/// least: they become evenly spaced.
void SceneRecording::thin() {
    std::size_t end = 0;
    for (std::size_t bytes = 0; 2 * bytes < m_stepBytes && end < m_steps.size(); ++end) bytes += m_steps[end].bytes();
    end = std::clamp<std::size_t>(end, 2, m_steps.size() - 1);
    std::uint64_t densest = m_steps.back().step;
    for (std::size_t k = 1; k < end; ++k) densest = std::min(densest, m_steps[k + 1].step - m_steps[k - 1].step);
    std::vector<Step> kept = {std::move(m_steps.front())};
    for (std::size_t k = 1; k < m_steps.size(); ++k) {
        if (k < end && 2 * (m_steps[k + 1].step - kept.back().step) <= 3 * densest) {
            kept.push_back(merged(m_steps[k], std::move(m_steps[k + 1])));
            ++k;
        } else {
            kept.push_back(std::move(m_steps[k]));
        }
    }
    m_steps = std::move(kept);
    dropUnusedLayouts();
    m_stepBytes = std::accumulate(m_steps.begin(), m_steps.end(), std::size_t{0},
                                  [](std::size_t sum, const Step& step) { return sum + step.bytes(); });
}

/// Those of steps that were forgotten.
void SceneRecording::dropUnusedLayouts() {
    std::vector<std::shared_ptr<const RenderScene>> used;
    for (Step& step : m_steps) {
        if (used.empty() || used.back() != m_layouts[step.layout]) used.push_back(m_layouts[step.layout]);
        step.layout = static_cast<std::uint32_t>(used.size() - 1);
    }
    m_layouts = std::move(used);
    m_layoutBytes = 0;
    for (const auto& layout : m_layouts) m_layoutBytes += bytesOf(*layout);
}

void SceneRecording::discardAfter(std::uint64_t step) {
    if (m_steps.empty() || m_steps.back().step <= step) return;
    while (!m_steps.empty() && m_steps.back().step > step) {
        m_stepBytes -= m_steps.back().bytes();
        m_steps.pop_back();
    }
    const std::size_t layouts = m_steps.empty() ? 0 : m_steps.back().layout + 1;
    for (; m_layouts.size() > layouts; m_layouts.pop_back()) m_layoutBytes -= bytesOf(*m_layouts.back());
    m_last.clear();
}

std::optional<std::uint64_t> SceneRecording::lastStepUntil(std::uint64_t step) const {
    const auto after = std::ranges::upper_bound(m_steps, step, {}, &Step::step);
    if (after == m_steps.begin()) return std::nullopt;
    return std::prev(after)->step;
}

std::shared_ptr<const RenderScene> SceneRecording::sceneAt(std::uint64_t step) const {
    const auto last = std::ranges::lower_bound(m_steps, step, {}, &Step::step);
    RUBBLE_ASSERT(last != m_steps.end() && last->step == step);
    auto from = last;
    while (!from->isKey) --from;
    const auto scene = std::make_shared<RenderScene>(*m_layouts[last->layout]);
    scene->poses.assign(scene->picks.size(), {});
    for (; from <= last; ++from) {
        for (const std::uint32_t body : from->hidden) {
            scene->poses[body] = {};
            scene->appearances[body].marks = kHidden;
        }
        for (const ShownBody& one : from->shown) {
            scene->poses[one.body] = one.pose;
            scene->appearances[one.body].marks = 0;
        }
    }
    if (last->lines) scene->lines = *last->lines;
    if (last->marks) scene->surfaceMarks = *last->marks;
    addEventEffects(*scene, m_scene->project, m_events, {step, m_stepLength, last->gravity});
    const Box3 bounds = boundsAt(*scene, scene->poses);
    scene->summary = SceneSummary{.bounds = bounds, .now = bounds, .hasTransparent = hasTransparentSurface(*scene)};
    return scene;
}

}  // namespace rubble
