#include "core/play/session/Timeline.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr std::size_t kMaxSnapshots = 48;
constexpr std::size_t kRecentSnapshots = 12;  // the last ones, which are never removed
constexpr std::size_t kMaxNearby = kSnapshotSteps / kNearbySteps + 2;

}  // namespace

Timeline::Timeline(Session session, std::vector<TimedInput> inputs, std::uint64_t steps, std::size_t maxSnapshotBytes)
    : m_session(std::move(session)),
      m_inputs(std::move(inputs)),
      m_length(m_session.stepsDone() + steps),
      m_maxSnapshotBytes(maxSnapshotBytes) {
    addSnapshot();
}

std::size_t Timeline::snapshotBytes() const {
    std::size_t bytes = 0;
    for (const Keyframe& one : m_keyframes) bytes += one.bytes;
    for (const Keyframe& one : m_nearby) bytes += one.bytes;
    return bytes;
}

Status Timeline::add(const PlayInput& input) {
    const std::uint64_t now = m_session.stepsDone();
    if (const Status earlier = addInputsUntil(now); !earlier) return earlier.error();  // earlier inputs come first
    if (const Status added = m_session.add(input); !added) return added.error();
    if (m_length > now) keepAsBranch();
    m_inputs.resize(m_added);
    m_length = now;
    removeSnapshotsAfter(now);
    m_inputs.push_back({now, input});
    m_added = m_inputs.size();
    return success();
}

Status Timeline::step() {
    if (const Status added = addInputsUntil(m_session.stepsDone()); !added) return added.error();
    m_session.step();
    m_length = std::max(m_length, m_session.stepsDone());
    if (m_session.stepsDone() >= m_keyframes.back().step + kSnapshotSteps) addSnapshot();
    return success();
}

Status Timeline::seek(std::uint64_t step, const TaskContext& task, const std::function<void()>& afterEach) {
    const std::uint64_t target = std::clamp(step, m_keyframes.front().step, m_length);
    const Keyframe& from = lastSnapshotUntil(target);
    if (target < m_session.stepsDone() || from.step > m_session.stepsDone()) restore(from);
    while (m_session.stepsDone() < target) {
        if (task.isCancelled()) return TaskContext::cancelled();
        if (const Status played = this->step(); !played) return played.error();
        if (m_session.stepsDone() + kSnapshotSteps >= target) addNearbySnapshot();
        if (afterEach) afterEach();
    }
    return success();
}

std::uint64_t Timeline::forkOf(const TimelineBranch& branch) const {
    std::uint64_t fork = std::min(m_length, branch.length);
    const auto [mine, other] = std::ranges::mismatch(m_inputs, branch.inputs);
    if (mine != m_inputs.end()) fork = std::min(fork, mine->step);
    if (other != branch.inputs.end()) fork = std::min(fork, other->step);
    return fork;
}

Status Timeline::switchTo(std::uint32_t id, const TaskContext& task) {
    const auto found = std::ranges::find(m_branches, id, &TimelineBranch::id);
    if (found == m_branches.end()) return Error{ErrorCode::BadInput, "There is no such earlier timeline."};
    const std::uint64_t fork = forkOf(*found);
    TimelineBranch current{m_id, std::move(m_inputs), m_length};
    m_id = found->id;
    m_inputs = std::move(found->inputs);
    m_length = found->length;
    m_branches.erase(found);
    m_branches.push_back(std::move(current));
    removeSnapshotsAfter(fork);
    restore(lastSnapshotUntil(fork));  // inputs of the former course may be pending
    return seek(fork, task);
}

/// The state now; inputs for this step are added again when it is restored.
Timeline::Keyframe Timeline::keyframe() const {
    return {m_session.stepsDone(), m_session.snapshot(), m_session.snapshotBytes()};
}

const Timeline::Keyframe& Timeline::lastSnapshotUntil(std::uint64_t step) const {
    const Keyframe* last = &*std::prev(std::ranges::upper_bound(m_keyframes, step, {}, &Keyframe::step));
    for (const Keyframe& one : m_nearby) {
        if (one.step <= step && one.step > last->step) last = &one;
    }
    return *last;
}

void Timeline::restore(const Keyframe& from) {
    m_session.restore(*from.snapshot);
    const auto next = std::ranges::lower_bound(m_inputs, from.step, {}, &TimedInput::step);
    m_added = static_cast<std::size_t>(next - m_inputs.begin());
}

/// Adds the inputs up to a step to the session.
Status Timeline::addInputsUntil(std::uint64_t step) {
    for (; m_added < m_inputs.size() && m_inputs[m_added].step <= step; ++m_added) {
        if (const Status added = m_session.add(m_inputs[m_added]); !added) return added.error();
    }
    return success();
}

/// Keeps the current course as a branch; what follows is another one.
void Timeline::startOver() {
    restore(m_keyframes.front());
    const std::uint64_t first = m_session.stepsDone();
    if (m_length > first && !m_inputs.empty()) keepAsBranch();
    m_inputs.clear();
    m_added = 0;
    m_length = first;
    removeSnapshotsAfter(first);
}

void Timeline::keepAsBranch() {
    if (m_branches.size() == kMaxBranches) m_branches.erase(m_branches.begin());
    m_branches.push_back({m_id, m_inputs, m_length});
    m_id = m_nextId++;
}

void Timeline::removeSnapshotsAfter(std::uint64_t step) {
    const auto isLater = [step](const Keyframe& one) { return one.step > step; };
    std::erase_if(m_keyframes, isLater);
    std::erase_if(m_nearby, isLater);
}

void Timeline::addSnapshot() {
    m_keyframes.push_back(keyframe());
    while (!m_nearby.empty() && snapshotBytes() > m_maxSnapshotBytes) m_nearby.pop_front();
    const auto isTooMuch = [&] { return m_keyframes.size() > kMaxSnapshots || snapshotBytes() > m_maxSnapshotBytes; };
    while (m_keyframes.size() > 2 && isTooMuch()) removeSnapshot();
}

/// Adds one unless there is one a few steps before, or the memory is used up.
void Timeline::addNearbySnapshot() {
    const std::uint64_t now = m_session.stepsDone();
    if (now < lastSnapshotUntil(now).step + kNearbySteps) return;
    if (m_nearby.size() == kMaxNearby) m_nearby.pop_front();
    if (snapshotBytes() + m_session.snapshotBytes() <= m_maxSnapshotBytes) m_nearby.push_back(keyframe());
}

/// Removes the snapshot with the closest neighbours: of the older ones, so that the recent ones stay dense and the
/// others become evenly spaced; of the recent ones if there are no others.
void Timeline::removeSnapshot() {
    const std::size_t last = m_keyframes.size() - 1;  // the first and the last one stay
    const std::size_t end = m_keyframes.size() > kRecentSnapshots + 1 ? m_keyframes.size() - kRecentSnapshots : last;
    std::size_t closest = 1;
    const auto gapAround = [&](std::size_t k) { return m_keyframes[k + 1].step - m_keyframes[k - 1].step; };
    for (std::size_t k = 2; k < end; ++k) {
        if (gapAround(k) < gapAround(closest)) closest = k;
    }
    m_keyframes.erase(m_keyframes.begin() + static_cast<std::ptrdiff_t>(closest));
}

Status playOn(Session session, std::vector<TimedInput> inputs, std::uint64_t steps, const TaskContext& task,
              const std::function<Status(const Session&)>& visit) {
    Timeline timeline(std::move(session), std::move(inputs), steps);
    while (timeline.session().stepsDone() < steps) {
        if (task.isCancelled()) return TaskContext::cancelled();
        if (const Status played = timeline.step(); !played) return played;
        if (const Status visited = visit(timeline.session()); !visited) return visited;
        task.report(static_cast<double>(timeline.session().stepsDone()) / static_cast<double>(steps));
    }
    return success();
}

}  // namespace rubble
