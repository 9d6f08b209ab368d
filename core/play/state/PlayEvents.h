#pragma once

#include "core/play/scene/PlayBody.h"
#include "core/play/scene/PlayInput.h"
#include "core/play/state/EnergyAudit.h"
#include "core/play/state/EventRecord.h"
#include "core/structure/clusters/ClusterLevels.h"

#include <memory>
#include <vector>

namespace rubble {

/// A body that broke in a step, and why.
struct PlayBreak {
    std::uint64_t step = 0;  // the first is 1
    PlayBody body;           // as it was before
    double impact = 0.0;     // N·s: the damage done to it
    double threshold = 0.0;  // N·s
    Vec3 point{0.0, 0.0, 0.0};
    Vec3 normal{0.0, 0.0, 0.0};            // from the impactor into the body
    BodyId impactor;                       // index 0 for hammers, blasts and BreakInput
    std::uint32_t impactorNumber = kNone;  // kNone without one
    double approachSpeed = 0.0;            // m/s, of the impactor
    std::uint32_t firstFragment = 0;       // number of its first fragment; the others follow, and those left out count
    std::uint32_t fragmentCount = 0;
    Pose pose;                               // of the whole's frame when it broke
    Vec3 velocity{0.0, 0.0, 0.0};            // m/s, of its centre then
    Vec3 angularVelocity{0.0, 0.0, 0.0};     // rad/s
    std::shared_ptr<const PlayAsset> asset;  // of its fragments: its own, or one cut at the point of impact
    double milliseconds = 0.0;  // wall-clock time of the swap: the only member that differs from run to run
};

/// A body that was hit in a step, and how close it came to breaking. With bonds: how close one of them came to that.
struct PlayImpact {
    std::uint32_t body = 0;  // its number
    double damage = 0.0;     // N·s
    /// N·s. With bonds: what would have broken the one that is loaded most, as it was damaged, see
    /// HitOutcome::utilization. Where the hit cannot damage any, or breaking is off: the weakest, if all went there.
    double threshold = 0.0;
    Vec3 point{0.0, 0.0, 0.0};
};

/// A body whose bonds broke in a step.
struct PlaySplit {
    std::uint64_t step = 0;                // the first is 1
    PlayBody body;                         // as it was before
    std::uint32_t impactorNumber = kNone;  // kNone without one
    double impulse = 0.0;                  // N·s, that the bonds took
    double approachSpeed = 0.0;            // m/s, of the impactor
    Vec3 point{0.0, 0.0, 0.0};
    Vec3 normal{0.0, 0.0, 0.0};        // from the impactor into the body
    std::uint32_t bonds = 0;           // that broke
    double area = 0.0;                 // m²: of the faces that they open, of both sides
    ClusterLevel level = kEveryLevel;  // at which it broke
    std::vector<std::uint32_t> freed;  // numbers of the bodies that came free, ascending
};

/// A body that was removed in a step, or some of the fragments that are bonded in it.
struct PlayRemoval {
    PlayBody body;  // as it was before
    RemovalReason reason = RemovalReason::LeftWorld;
    std::vector<std::uint32_t> fragments;  // of its asset's bake, ascending: what was removed of it; none: all
    BodyState state;                       // of the body
    Vec3 centre{0.0, 0.0, 0.0};            // m, of mass
    double mass = 0.0;                     // kg
    Box3 box;                              // m
};

/// What happened in the last step, in a fixed order.
struct PlayEvents {
    std::vector<TimedInput> inputs;  // applied before it
    std::vector<PlayBreak> breaks;
    std::vector<PlaySplit> splits;
    std::vector<PlayImpact> impacts;      // on breakable bodies, by body, after those on bonded ones
    std::vector<PlayBody> born;           // fragments and projectiles
    std::vector<PlayRemoval> removed;     // debris that was removed, and bodies that left the world, by number
    std::vector<PlayRemoval> taken;       // by inputs
    std::vector<Diagnostic> diagnostics;  // UnappliedInput, PatternFallback and LeftWorld
    EnergyAudit energy;                   // of inputs and breaks, not of the solver
    /// All that happened, and what contacts did, in that order: without the step and the names of fragments.
    std::vector<EventRecord> happened;
    OmittedEvents weakImpacts;  // below the least energy, which are not among them
    EventReport report;         // the strongest of it
};

/// Adds what happened in an interval of a step to what happened in it before.
void append(PlayEvents&& interval, PlayEvents& step);

}  // namespace rubble
