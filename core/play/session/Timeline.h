#pragma once

#include "core/base/TaskContext.h"
#include "core/play/session/Session.h"

#include <deque>
#include <functional>
#include <vector>

namespace rubble {

inline constexpr std::uint64_t kSnapshotSteps = 60;  // between the most recent snapshots
inline constexpr std::uint64_t kNearbySteps = 10;    // between snapshots before a step that was sought
/// The default limit of 256 MiB holds ten snapshots of 8,000 bodies, or all 48 of up to 1,500.
inline constexpr std::size_t kMaxSnapshotBytes = std::size_t{256} << 20;

inline constexpr std::size_t kMaxBranches = 12;

/// Another course of a session: its inputs and how far it was played.
struct TimelineBranch {
    std::uint32_t id = 0;            // unique in its timeline
    std::vector<TimedInput> inputs;  // ascending step
    std::uint64_t length = 0;        // steps
};

/// A session with its history: it can seek to any step and continue from there. Inputs and occasional snapshots are
/// kept; a seek restores the nearest snapshot and replays the steps after it. An input in the past keeps the former
/// future as a branch, of which only the inputs are kept.
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

    /// Adds an input before the next step. The steps known after this one become a branch; the oldest of more than
    /// kMaxBranches is dropped.
    ///
    /// Errors: those of Session::add(); nothing changes then.
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

    /// Goes back to the first step and drops all inputs. A course that had some becomes a branch.
    void startOver();

    /// The other courses, oldest first.
    const std::vector<TimelineBranch>& branches() const { return m_branches; }
    /// The last step up to which a branch and the current course are the same.
    std::uint64_t forkOf(const TimelineBranch& branch) const;
    /// Exchanges the current course with a branch, and seeks to their fork. The id of a branch is that of its course:
    /// the current course becomes the branch `currentId()` was.
    ///
    /// Errors: BadInput for an unknown id, nothing changes then; those of seek().
    Status switchTo(std::uint32_t id, const TaskContext& task = {});
    std::uint32_t currentId() const { return m_id; }

private:
    struct Keyframe {
        std::uint64_t step = 0;
        std::shared_ptr<const SessionSnapshot> snapshot;
        std::size_t bytes = 0;
    };
    Keyframe keyframe() const;
    void addSnapshot();
    void addNearbySnapshot();
    void removeSnapshot();
    const Keyframe& lastSnapshotUntil(std::uint64_t step) const;
    void restore(const Keyframe& from);
    Status addInputsUntil(std::uint64_t step);
    void keepAsBranch();
    void removeSnapshotsAfter(std::uint64_t step);

    Session m_session;
    std::vector<TimedInput> m_inputs;
    std::size_t m_added = 0;  // of the inputs: those that the session has received
    std::uint64_t m_length = 0;
    std::vector<Keyframe> m_keyframes;  // ascending step; the first is the start
    std::deque<Keyframe> m_nearby;      // of recent seeks, oldest first: stepping back replays a few steps
    std::uint32_t m_id = 0;             // of the current course
    std::uint32_t m_nextId = 1;
    std::vector<TimelineBranch> m_branches;
    std::size_t m_maxSnapshotBytes;
};

/// Plays a session on, with inputs (ascending step), until `steps` steps are done, and calls visit(session) after each.
///
/// Errors: those of Timeline::step() and of `visit`; Cancelled.
Status playOn(Session session, std::vector<TimedInput> inputs, std::uint64_t steps, const TaskContext& task,
              const std::function<Status(const Session&)>& visit);

}  // namespace rubble
