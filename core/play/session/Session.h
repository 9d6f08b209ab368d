#pragma once

#include "core/base/Hash.h"
#include "core/play/state/SessionState.h"

namespace rubble {

/// A project while it is simulated: its instances on its ground, inputs, and bodies that are swapped for their
/// fragments when they break. A step is: apply inputs, collide, break and swap, collide the fragments, solve, remove
/// debris. Where something is hit that may break, the step is played in intervals, see HitIntervals.h.
///
/// The same scene, inputs and step length give the same bits, on any number of threads and lanes.
class Session {
public:
    /// Errors: BadInput for a step length out of range (ProjectNumber::StepLength), or an instance that cannot be
    /// placed.
    static Result<Session> start(std::shared_ptr<const PlayScene> scene, const SessionSettings& settings = {});
    ~Session();
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;

    /// Adds an input for the next step, or for a later one; inputs of the same step are applied in the order they were
    /// added.
    ///
    /// Errors: BadInput for an unusable projectile, a threshold that is not positive, a number that is not finite, a
    /// missing id or body, a past step.
    Status add(const PlayInput& input);
    Status add(const TimedInput& timed);
    /// Adds a shot of the project at its time, counted from now: before the first step that starts no earlier.
    Status add(const Shot& shot);

    void step();

    /// Whether nothing will change until the next input: all bodies sleep, none is grabbed, fades out or is about to
    /// lose its support, and no input waits. Only the number of steps grows.
    bool isAtRest() const;

    std::uint64_t stepsDone() const;
    double stepLength() const;
    bool isSleeping() const;  // true where bodies at rest are put to sleep
    const PlayScene& scene() const;
    const World& world() const;
    /// All bodies by number: the ground (0, if there is one), instances in the project's order, then in order of
    /// creation.
    const std::vector<PlayBody>& bodies() const;
    /// The body with a number; null if it is gone.
    const PlayBody* body(std::uint32_t number) const;
    /// The same, also if it broke or was removed in the last step.
    const PlayBody* recentBody(std::uint32_t number) const;
    const std::vector<PlayOrigin>& origins() const;
    /// The structures of which bonds were damaged; see PlayBody::structure.
    const std::vector<StructureState>& structures() const;
    std::string nameOf(const PlayBody& body) const;
    /// The smallest damage that breaks a body, N·s; infinite if it does not break.
    double thresholdOf(const PlayBody& body) const;
    /// How far a body has faded out, in [0, 1].
    double fadeOf(const PlayBody& body) const;
    bool hasDestruction() const;
    /// The damage of all instances.
    SessionDamage damage() const;
    /// Breaks what is broken in a damage and not yet here, without force, level by level, in order of the bodies'
    /// numbers: applied to a fresh session, the fragments are at their rest poses. Its events are not those of a step
    /// and are dropped, but diagnostics.
    ///
    /// Errors, with the instance; nothing changes then: BadInput for a missing or unbreakable instance, a damage of
    /// another bake, see damageFault(), or one that was cut at another point than the instance here.
    Status apply(const SessionDamage& damage);

    const PlayEvents& events() const;
    /// The potential energy of the fragments that anchors hold, J, zero at the origin as World::momenta(): with that it
    /// is continuous where they come free.
    double heldPotential() const;
    /// The time that the last step spent on breaks and swaps, ms; the rest is World::times().
    double swapMilliseconds() const;
    ContentHash hash() const { return world().hash(); }

    /// Everything that the next steps depend on, including pending inputs.
    std::shared_ptr<const SessionSnapshot> snapshot() const;
    void restore(const SessionSnapshot& snapshot);
    /// Puts all bodies to sleep where they are, see World::sleepInPlace().
    void sleepInPlace() { m_world.sleepInPlace(m_settings.dt); }
    /// The memory that a snapshot taken now needs, in bytes.
    std::size_t snapshotBytes() const;

private:
    Session(std::shared_ptr<const PlayScene> scene, const SessionSettings& settings);
    /// The impacts of the coming dt seconds on what may break.
    std::vector<Impact> impactsWithin(double dt);
    /// The same, exactly: no manifold of what does not touch yet is recycled.
    std::vector<Impact> hitsWithin(double dt);
    /// Breaks what impacts break in an interval of a step, and simulates it.
    void playInterval(std::span<const Impact> impacts, double dt);

    std::shared_ptr<const PlayScene> m_scene;
    SessionSettings m_settings;
    std::unique_ptr<SessionState> m_state;
    World m_world;
    double m_swapMilliseconds = 0.0;
};

/// The number of steps of dt before a shot at this time is due.
std::uint64_t stepOf(double time, double dt);

}  // namespace rubble
