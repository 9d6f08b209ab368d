#pragma once

#include "core/play/session/Timeline.h"

#include <optional>
#include <string>

namespace rubble {

/// A body that moved in a step, with a 32-bit hash of its pose and velocities.
struct BodyCheck {
    std::uint32_t body = 0;  // its number
    std::uint32_t check = 0;
    Vec3 velocity{0.0, 0.0, 0.0};  // m/s, rounded to 1e-6: measures a difference that the hash only shows
    bool operator==(const BodyCheck&) const = default;
};

/// A body that broke in a step.
struct ReplayBreak {
    std::uint32_t body = 0;  // its number
    double impact = 0.0;     // N·s
    bool operator==(const ReplayBreak&) const = default;
};

struct ReplayStep {
    std::uint64_t hash = 0;               // of all bodies after the step
    std::vector<BodyCheck> moved;         // the bodies awake after the step, by number
    std::vector<ReplayBreak> broke;       // in order of their breaks
    std::optional<std::uint64_t> events;  // EventReport::hash(); none in older recordings
    bool operator==(const ReplayStep&) const = default;
};

/// The pose of a body.
struct ReplayBody {
    std::uint32_t number = 0;
    Pose pose;
    bool operator==(const ReplayBody&) const = default;
};

/// The poses of all bodies after a step.
struct ReplayKeyframe {
    std::uint64_t step = 0;
    std::vector<ReplayBody> bodies;  // by number
    bool operator==(const ReplayKeyframe&) const = default;
};

inline constexpr std::uint64_t kKeyframeSteps = 60;

/// A recorded session. Replaying the inputs with the same project reproduces it; hashes verify it, or locate the first
/// divergence.
struct Replay {
    std::string program;  // name and version of the recording program
    ContentHash project;  // hash of the played project
    double dt = 1.0 / 60.0;
    bool sleeping = true;
    bool hasDestruction = true;
    std::vector<TimedInput> inputs;  // ascending step
    std::vector<ReplayStep> steps;
    std::vector<ReplayKeyframe> keyframes;  // after every kKeyframeSteps steps
    bool isDetailed = true;                 // false: the steps hold neither velocities nor breaks
    bool operator==(const Replay&) const = default;
};

/// Records a session while it is played.
class ReplayRecorder {
public:
    /// Must be created before the session's first step.
    ReplayRecorder(const Session& session, std::string program, ContentHash project);

    /// Must be called after each step.
    void add(const Session& session);
    const Replay& replay() const { return m_replay; }

private:
    Replay m_replay;
};

/// Plays inputs (ascending step) for the given number of steps from the start and records them.
///
/// Errors: those of Session::start() and Timeline::seek(); Cancelled.
Result<Replay> recordReplay(std::shared_ptr<const PlayScene> scene, const SessionSettings& settings,
                            std::vector<TimedInput> inputs, std::uint64_t steps, std::string program,
                            ContentHash project, const TaskContext& task = {});

/// How a body differs from the recording.
enum class DivergenceKind {
    Unmeasured,   // it differs; the recording does not say by how much
    Broke,        // it broke, but not in the recording
    DidNotBreak,  // it broke in the recording only
    Velocity,
    Events,  // all bodies are the same, but what the step reports of them is not
};

/// The first difference between a replay and its recording.
struct Divergence {
    std::uint64_t step = 0;  // the first is 1
    /// The body that differs most in this step: of those that broke on one side only the one that was hit hardest; else
    /// the one whose velocity differs most; else the lowest-numbered one. Empty if unknown.
    std::string body;
    DiagnosticPlace place;  // of the body: its asset and fragment
    DivergenceKind kind = DivergenceKind::Unmeasured;
    double difference = 0.0;  // the impact that broke it, N·s; or the difference of velocities, m/s
    struct Distance {
        std::uint64_t step = 0;
        std::string body;     // the one farthest from its recorded position
        double metres = 0.0;  // its distance from it
    };
    std::optional<Distance> distance;  // at the next keyframe, once it has been played
    /// The divergence as a ReplayMismatch: `At step 12 "front 4.1" breaks under an impact of 1321 N·s; in the
    /// recording it does not.` Its value is the difference.
    Diagnostic diagnostic() const;
};

/// Plays a replay, seeks in it, and compares it with its recording.
class ReplayPlayer {
public:
    /// Errors: those of Session::start() and Session::add(). `settings` gives threads and lanes; the rest comes from
    /// the replay.
    static Result<ReplayPlayer> start(std::shared_ptr<const PlayScene> scene, Replay replay,
                                      const SessionSettings& settings = {});

    const Replay& replay() const { return m_replay; }
    const Session& session() const { return m_timeline.session(); }
    /// Goes to the state after `step` steps, at most the length of the replay.
    ///
    /// Errors: those of Timeline::seek().
    Status seek(std::uint64_t step, const TaskContext& task = {});
    /// The first divergence in the steps played so far.
    const std::optional<Divergence>& divergence() const { return m_divergence; }

private:
    ReplayPlayer(Replay replay, Timeline timeline) : m_replay(std::move(replay)), m_timeline(std::move(timeline)) {}
    void compare();

    Replay m_replay;
    Timeline m_timeline;
    std::optional<Divergence> m_divergence;
};

}  // namespace rubble
