#include "core/play/Timeline.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr std::size_t kMostKept = 48;    // snapshots
constexpr std::size_t kRecentKept = 12;  // of them: the last, which are never thinned out

}  // namespace

Timeline::Timeline(Session session, std::vector<TimedInput> inputs, std::uint64_t steps)
    : m_session(std::move(session)), m_inputs(std::move(inputs)), m_length(m_session.stepsDone() + steps) {
    m_kept.push_back({m_session.stepsDone(), m_session.snapshot()});
}

Status Timeline::add(const PlayInput& input) {
    const std::uint64_t now = m_session.stepsDone();
    if (const Status fed = feed(now); !fed) return fed.error();  // those that were there first come first
    if (const Status added = m_session.add(input); !added) return added.error();
    forgetBeyond(now);
    m_inputs.push_back({now, input});
    m_fed = m_inputs.size();
    return success();
}

Status Timeline::step() {
    if (const Status fed = feed(m_session.stepsDone()); !fed) return fed.error();
    m_session.step();
    m_length = std::max(m_length, m_session.stepsDone());
    keepSnapshot();
    return success();
}

Status Timeline::seek(std::uint64_t step, const TaskContext& task, const std::function<void()>& afterEach) {
    const std::uint64_t aim = std::clamp(step, m_kept.front().step, m_length);
    const Kept& from = *std::prev(std::ranges::upper_bound(m_kept, aim, {}, &Kept::step));
    if (aim < m_session.stepsDone() || from.step > m_session.stepsDone()) {
        m_session.restore(*from.snapshot);
        const auto fed = std::ranges::lower_bound(m_inputs, from.step, {}, &TimedInput::step);
        m_fed = static_cast<std::size_t>(fed - m_inputs.begin());
    }
    while (m_session.stepsDone() < aim) {
        if (task.isCancelled()) return TaskContext::cancelled();
        if (const Status played = this->step(); !played) return played.error();
        if (afterEach) afterEach();
    }
    return success();
}

/// Gives the session the inputs of a step.
Status Timeline::feed(std::uint64_t step) {
    for (; m_fed < m_inputs.size() && m_inputs[m_fed].step <= step; ++m_fed) {
        if (const Status added = m_session.add(m_inputs[m_fed]); !added) return added.error();
    }
    return success();
}

void Timeline::forgetBeyond(std::uint64_t step) {
    m_inputs.resize(m_fed);
    m_length = step;
    std::erase_if(m_kept, [&](const Kept& kept) { return kept.step > step; });
}

/// Keeps one every so many steps. Where they are too many, of the older ones that goes whose neighbours are nearest to each other, so
/// that they come to lie evenly, and those of the last seconds densely.
void Timeline::keepSnapshot() {
    const std::uint64_t step = m_session.stepsDone();
    if (step < m_kept.back().step + kSnapshotSteps) return;
    m_kept.push_back({step, m_session.snapshot()});
    if (m_kept.size() <= kMostKept) return;
    std::size_t least = 1;
    const auto gapAround = [&](std::size_t k) { return m_kept[k + 1].step - m_kept[k - 1].step; };
    for (std::size_t k = 2; k + kRecentKept < m_kept.size(); ++k) {
        if (gapAround(k) < gapAround(least)) least = k;
    }
    m_kept.erase(m_kept.begin() + static_cast<std::ptrdiff_t>(least));
}

}  // namespace rubble
