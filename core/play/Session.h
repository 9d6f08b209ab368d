#pragma once

#include "core/base/Hash.h"
#include "core/play/Breaks.h"
#include "core/play/PlayInput.h"
#include "core/play/PlayScene.h"

namespace rubble {

struct SessionSettings {
    double dt = 1.0 / 60.0;  // s, of a step
    bool sleeping = true;
    bool hasDestruction = true;  // until a DestructionInput says otherwise
    int threads = 1;
    LaneWidth lanes = widestLanes();
};

/// A body that was hit in a step, and how near it came to breaking.
struct PlayImpact {
    std::uint32_t body = 0;  // its number
    double damage = 0.0;     // N s
    double threshold = 0.0;  // N s
    Vec3 point{0.0, 0.0, 0.0};
};

/// What happened in the last step, in a fixed order.
struct PlayEvents {
    std::vector<TimedInput> inputs;  // that were followed before it
    std::vector<PlayBreak> breaks;
    std::vector<PlayImpact> impacts;   // on bodies that can break, by body
    std::vector<PlayBody> born;        // pieces and missiles
    std::vector<PlayBody> removed;     // debris that was taken away, and what fell out of the world
    std::vector<std::string> notices;  // sentences about inputs that could not be followed as they were
};

struct SessionState;
struct SessionSnapshot;

/// A project in motion: its instances stand on its ground, inputs are followed, what is hit hard enough is swapped for its
/// pieces. A step is: inputs, collide, breaks and swaps, collide the newcomers, solve, debris.
///
/// Same scene, inputs and step length: same bits, on any number of threads and lanes.
class Session {
public:
    /// Errors: BadInput for a step length outside [kShortestStep, kLongestStep] or an instance that cannot be placed.
    static Result<Session> start(std::shared_ptr<const PlayScene> scene, const SessionSettings& settings = {});
    ~Session();
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;

    /// Follows an input before the next step, or before the step after `atStep` ones; of equal times the earlier given
    /// first.
    ///
    /// Errors: BadInput where the input has no use: something that cannot be thrown, a threshold that is not positive, a
    /// number that is not finite, an id or body that is not there, a time that is past.
    Status add(const PlayInput& input);
    Status add(const TimedInput& timed);
    /// Follows a shot of the project at its time: before the first step that begins no earlier.
    Status add(const Shot& shot);

    void step();

    std::uint64_t stepsDone() const;
    double stepLength() const;
    bool isSleeping() const;  // whether bodies at rest are left out
    const PlayScene& scene() const;
    const World& world() const;
    /// All that are there, by number: ground (0, if there is one), instances in the project's order, then as they were born.
    const std::vector<PlayBody>& bodies() const;
    /// The body of a number; null where it is gone.
    const PlayBody* body(std::uint32_t number) const;
    const std::vector<PlayOrigin>& origins() const;
    std::string nameOf(const PlayBody& body) const;
    /// N s; the least that breaks a body. Infinite where it does not break.
    double thresholdOf(const PlayBody& body) const;
    /// In [0, 1]: how much of a body has faded away.
    double fadeOf(const PlayBody& body) const;
    bool hasDestruction() const;

    const PlayEvents& events() const;
    /// The breaks of the last kRecentTime, for drawing: what dust they raised is not seen in one step.
    const std::vector<PlayBreak>& recentBreaks() const;
    /// Milliseconds that the last step spent on breaks and swaps; the rest is World::times().
    double swapMilliseconds() const;
    ContentHash hash() const { return world().hash(); }

    /// Everything that the next step depends on, inputs to come included.
    std::shared_ptr<const SessionSnapshot> snapshot() const;
    void restore(const SessionSnapshot& snapshot);

private:
    Session(std::shared_ptr<const PlayScene> scene, const SessionSettings& settings);

    std::shared_ptr<const PlayScene> m_scene;
    SessionSettings m_settings;
    std::unique_ptr<SessionState> m_state;
    World m_world;
    double m_swapMilliseconds = 0.0;
};

inline constexpr double kShortestStep = 1e-5;  // s: shorter steps drown in rounding
inline constexpr double kLongestStep = 0.1;    // s: longer ones are no motion any more

inline constexpr double kRecentTime = 1.0;  // s

/// After how many steps of dt a shot of this time is due.
std::uint64_t stepOf(double time, double dt);

}  // namespace rubble
