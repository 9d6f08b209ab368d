#pragma once

#include "core/play/Timeline.h"

#include <optional>
#include <string>

namespace rubble {

/// A body that moved in a step: 32 bits over its pose and velocities.
struct BodyCheck {
    std::uint32_t body = 0;  // its number
    std::uint32_t check = 0;
    bool operator==(const BodyCheck&) const = default;
};

struct ReplayStep {
    std::uint64_t hash = 0;        // over all bodies after it
    std::vector<BodyCheck> moved;  // the bodies that are awake after it, by number
    bool operator==(const ReplayStep&) const = default;
};

/// Where a body was.
struct ReplayBody {
    std::uint32_t number = 0;
    Pose pose;
    bool operator==(const ReplayBody&) const = default;
};

/// All bodies after so many steps.
struct ReplayKeyframe {
    std::uint64_t step = 0;
    std::vector<ReplayBody> bodies;  // by number
    bool operator==(const ReplayKeyframe&) const = default;
};

inline constexpr std::uint64_t kKeyframeSteps = 60;

/// A session as it was played: what came to it, and what it came to, step by step. With the same project the inputs make it
/// come about again; the rest proves it, or tells where it went another way.
struct Replay {
    std::string program;  // that recorded it
    ContentHash project;  // that was played
    double dt = 1.0 / 60.0;
    bool sleeping = true;
    bool hasDestruction = true;
    std::vector<TimedInput> inputs;  // ascending step
    std::vector<ReplayStep> steps;
    std::vector<ReplayKeyframe> keyframes;  // after every kKeyframeSteps steps
    bool operator==(const Replay&) const = default;
};

/// Writes a session down while it is played.
class ReplayRecorder {
public:
    /// Before the session's first step. `program` and `project` name what records and what is played.
    ReplayRecorder(const Session& session, std::string program, ContentHash project);

    /// After each step.
    void add(const Session& session);
    const Replay& replay() const { return m_replay; }

private:
    Replay m_replay;
};

/// Plays inputs (ascending step) for so many steps from the start, and writes it down.
///
/// Errors: those of Session::start() and Timeline::seek(); Cancelled.
Result<Replay> recorded(std::shared_ptr<const PlayScene> scene, const SessionSettings& settings,
                        std::vector<TimedInput> inputs, std::uint64_t steps, std::string program, ContentHash project,
                        const TaskContext& task = {});

/// Where a replay first went another way than it was recorded.
struct Divergence {
    std::uint64_t step = 0;  // the first is 1
    std::string body;        // the first by number that moves differently; empty where none is told apart
    struct Distance {
        std::uint64_t step = 0;
        double metres = 0.0;  // of the body that is farthest off
    };
    std::optional<Distance> distance;  // at the next keyframe, once that was played
    /// `At step 12 "front 4.1" went another way than it was recorded.`
    std::string sentence() const;
};

/// Plays a replay again, forwards and backwards, and compares.
class ReplayPlayer {
public:
    /// Errors: those of Session::start() and Session::add(). `settings` say threads and lanes; the rest is the replay's.
    static Result<ReplayPlayer> start(std::shared_ptr<const PlayScene> scene, Replay replay,
                                      const SessionSettings& settings = {});

    const Replay& replay() const { return m_replay; }
    const Session& session() const { return m_timeline.session(); }
    /// Goes to the moment after so many steps, at most those of the replay.
    ///
    /// Errors: those of Timeline::seek().
    Status seek(std::uint64_t step, const TaskContext& task = {});
    /// The first of all steps played so far that came out differently.
    const std::optional<Divergence>& divergence() const { return m_divergence; }

private:
    ReplayPlayer(Replay replay, Timeline timeline) : m_replay(std::move(replay)), m_timeline(std::move(timeline)) {}
    void compare();

    Replay m_replay;
    Timeline m_timeline;
    std::optional<Divergence> m_divergence;
};

}  // namespace rubble
