#pragma once

#include "core/play/session/Session.h"

#include <functional>
#include <vector>

namespace rubble {

inline constexpr std::uint64_t kSnapshotSteps = 60;  // between the most recent snapshots
/// The default limit of 256 MiB holds ten snapshots of 8,000 bodies, or all 48 of up to 1,500.
inline constexpr std::size_t kMaxSnapshotBytes = std::size_t{256} << 20;

/// A session with its history: it can seek to any step and continue from there. Inputs and occasional snapshots are
/// kept; a seek restores the nearest snapshot and replays the steps after it.
class Timeline {
public:
    /// Starts from a session without pending inputs, with inputs (ascending step) for its next `steps` steps.
    /// The snapshots together need at most `maxSnapshotBytes`, but the first and the last one are always kept.
    explicit Timeline(Session session, std::vector<TimedInput> inputs = {}, std::uint64_t steps = 0,
                      std::size_t maxSnapshotBytes = kMaxSnapshotBytes);

    const Session& session() const { return m_session; }
    /// The number of known steps; playing beyond it extends it.
    std::uint64_t length() const { return m_length; }
    /// The memory of all snapshots.
    std::size_t snapshotBytes() const;
    bool isAtEnd() const { return m_session.stepsDone() == m_length; }
    /// All inputs, ascending step.
    const std::vector<TimedInput>& inputs() const { return m_inputs; }

    /// Adds an input before the next step, and discards everything known after this step.
    ///
    /// Errors: those of Session::add(); nothing is discarded then.
    Status add(const PlayInput& input);
    /// Plays one step, again or for the first time.
    ///
    /// Errors: those of Session::add(), for an input given at construction.
    Status step();
    /// Goes to the state after `step` steps, clamped to [first step, length()]. `afterEach` is called after each step
    /// that is played; steps before the restored snapshot are skipped.
    ///
    /// Errors: those of step(); Cancelled.
    Status seek(std::uint64_t step, const TaskContext& task = {}, const std::function<void()>& afterEach = {});

private:
    struct Keyframe {
        std::uint64_t step = 0;
        std::shared_ptr<const SessionSnapshot> snapshot;
        std::size_t bytes = 0;
    };
    void addSnapshot();
    void removeSnapshot();
    Status addInputsUntil(std::uint64_t step);
    void discardAfter(std::uint64_t step);

    Session m_session;
    std::vector<TimedInput> m_inputs;
    std::size_t m_added = 0;  // of the inputs: those that the session has received
    std::uint64_t m_length = 0;
    std::vector<Keyframe> m_keyframes;  // ascending step; the first is the start
    std::size_t m_maxSnapshotBytes;
};

}  // namespace rubble
