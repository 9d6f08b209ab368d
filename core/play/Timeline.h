#pragma once

#include "core/play/Session.h"

#include <functional>
#include <vector>

namespace rubble {

/// A session with its past: one can go back in it, and play on from any moment. What came to it is kept, and a snapshot now and
/// then: to go elsewhere, the nearest one is restored and what follows is played again.
class Timeline {
public:
    /// Begins at the moment of a session that no input waits for, with those that are to come within the next `steps` steps
    /// (ascending step).
    explicit Timeline(Session session, std::vector<TimedInput> inputs = {}, std::uint64_t steps = 0);

    const Session& session() const { return m_session; }
    /// How many steps are known: at most at the end of them something new happens.
    std::uint64_t length() const { return m_length; }
    bool isAtEnd() const { return m_session.stepsDone() == m_length; }
    /// All that came to the session, ascending step.
    const std::vector<TimedInput>& inputs() const { return m_inputs; }

    /// Follows an input before the next step. What was played beyond this moment is forgotten: from here it goes another way.
    ///
    /// Errors: those of Session::add(); then nothing is forgotten.
    Status add(const PlayInput& input);
    /// Plays a step: again, or a new one where all known are done.
    ///
    /// Errors: those of Session::add(), for an input that was told at the beginning.
    Status step();
    /// Goes to the moment after so many steps, at most length() and at least the first. `afterEach` is called after each step
    /// that is played on the way; what was played before may be leapt over.
    ///
    /// Errors: those of step(); Cancelled.
    Status seek(std::uint64_t step, const TaskContext& task = {}, const std::function<void()>& afterEach = {});

private:
    struct Kept {
        std::uint64_t step = 0;
        std::shared_ptr<const SessionSnapshot> snapshot;
    };
    void keepSnapshot();
    Status feed(std::uint64_t step);
    void forgetBeyond(std::uint64_t step);

    Session m_session;
    std::vector<TimedInput> m_inputs;
    std::size_t m_fed = 0;  // of the inputs: those that the session was given
    std::uint64_t m_length = 0;
    std::vector<Kept> m_kept;  // ascending step; the first is the start
};

inline constexpr std::uint64_t kSnapshotSteps = 60;  // between the snapshots of what was played last

}  // namespace rubble
