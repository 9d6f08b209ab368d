#pragma once

#include "core/physics/state/WorldState.h"

namespace rubble {

/// Whether a dynamic body is at rest: either it hardly moved in half a second, by a small fraction of a fall in that
/// time, or it rattles, as one wedged between others may do forever: it goes to and fro, and stays within two
/// centimetres. Bodies that accelerate or drift are slow, but not at rest; without gravity, only what does not move is.
bool isAtRest(const WorldState& state, std::uint32_t body);

/// The movement of a body in a step.
struct StepMovement {
    Vec3f displacement{0.0f, 0.0f, 0.0f};  // m, of its centre
    Vec3f rotation{0.0f, 0.0f, 0.0f};      // rad, in world axes
};
StepMovement movementOf(const BodyMotion& motion);

/// Updates for how long an awake body has been at rest, after a step of dt seconds in which it moved.
void updateRestTime(WorldState& state, std::uint32_t body, const StepMovement& movement, float dt);
/// The half second of a body begins again: it may be disturbed.
void interruptRest(WorldState& state, std::uint32_t body);
/// Forgets for how long a body has been at rest or rattled.
void restartRest(WorldState& state, std::uint32_t body);
/// Declares a body at rest until it moves.
void setAtRest(WorldState& state, std::uint32_t body);

}  // namespace rubble
