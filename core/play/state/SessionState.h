#pragma once

#include "core/physics/world/World.h"
#include "core/play/damage/InstanceDamage.h"
#include "core/play/scene/PlayScene.h"
#include "core/play/state/KeptSupport.h"
#include "core/play/state/PlayEvents.h"
#include "core/play/state/StructureState.h"

#include <map>

namespace rubble {

struct SessionSettings {
    double dt = 1.0 / 60.0;  // s, length of a step
    bool sleeping = true;
    bool hasDestruction = true;  // until a DestructionInput changes it
    int threads = 1;
    SimdWidth lanes = widestSimd();
    bool checksEnergy = true;  // RUBBLE_ASSERT that only sources add energy; not where damaged assets are examined
    bool operator==(const SessionSettings&) const = default;
};

/// An impact that was reported: while its bodies go on touching, their next ones are not.
struct ReportedImpact {
    std::uint32_t first = 0;  // numbers of the bodies, first < second
    std::uint32_t second = 0;
    std::uint64_t apartSince = kTouching;  // step after which they no longer touched
    static constexpr std::uint64_t kTouching = ~std::uint64_t{0};
};

/// Everything in a session that changes, except its world.
struct SessionState {
    std::uint64_t step = 0;
    double elapsed = 0.0;       // s: of the step that is being played
    double dividedUntil = 0.0;  // s: until then steps are played in intervals, see HitIntervals.h
    bool hasDestruction = true;
    std::vector<PlayBody> bodies;  // ascending number
    std::uint32_t nextNumber = 0;
    std::vector<PlayOrigin> origins;
    std::map<std::uint32_t, InstanceDamage> damage;  // by origin, of those that broke
    std::vector<StructureState> structures;          // of solids whose bonds were damaged, in order of that
    std::vector<TimedInput> pending;                 // ascending step; equal steps in the order they were added
    std::vector<Material> materials;                 // with their current values; ascending id
    std::map<Id, double> assetThresholds;
    std::map<Id, double> instanceThresholds;  // of instances with their own
    double lowest = 0.0;                      // m: bodies below it have left the world
    PlayEvents events;
    std::vector<ReportedImpact> reportedImpacts;  // ascending bodies
    KeptSupports keptSupports;                    // follows from the scene and the structures
};

struct SessionSnapshot {
    SessionState state;
    std::shared_ptr<const Snapshot> world;
};

/// The time that has been simulated, s, by steps of dt.
inline double timeOf(const SessionState& state, double dt) {
    return static_cast<double>(state.step) * dt + state.elapsed;
}

/// The memory of a state, in bytes: of everything that grows with its bodies. Assets and hulls are shared and not
/// counted.
std::size_t byteCount(const SessionState& state);

/// The parts of a session that the functions carrying out a step work on. One that changes state or world takes
/// `SessionParts&`; one that only reads takes `const SessionParts&`, through which nothing can be changed. Not copied,
/// since a copy of what can only be read could change it.
class SessionParts {
public:
    SessionParts(const PlayScene& scene, const SessionSettings& settings, SessionState& state, World& world)
        : m_scene(scene), m_settings(settings), m_state(state), m_world(world) {}
    SessionParts(const SessionParts&) = delete;
    SessionParts& operator=(const SessionParts&) = delete;

    const PlayScene& scene() const { return m_scene; }
    const SessionSettings& settings() const { return m_settings; }
    const SessionState& state() const { return m_state; }
    SessionState& state() { return m_state; }
    const World& world() const { return m_world; }
    World& world() { return m_world; }

private:
    const PlayScene& m_scene;
    const SessionSettings& m_settings;
    SessionState& m_state;
    World& m_world;
};

}  // namespace rubble
