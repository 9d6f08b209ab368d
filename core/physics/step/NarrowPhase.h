#pragma once

#include "core/physics/narrowphase/HullCollision.h"
#include "core/physics/solver/SolverKernels.h"
#include "core/physics/state/Regions.h"
#include "core/physics/state/WorldState.h"

namespace rubble {

/// The pose of a hull of the second body in the frame of one of the first; the offsets are those of PlacedHull.
RelativePose relativePose(const BodyPose& first, Vec3f firstOffset, const BodyPose& second, Vec3f secondOffset);

/// Collides the hulls of a contact at their poses, or, if they move fast relative to their width and are apart, at
/// their time of impact within the next dt seconds.
HullCollision collideContact(const WorldState& state, const Contact& contact, float dt);

/// Writes a manifold to the lane of a contact.
void storeManifold(WorldState& state, std::uint32_t contact, const HullCollision& collision);

/// Sets when a contact without a manifold must be collided again: when its bodies may have closed most of the gap.
void storeGap(WorldState& state, std::uint32_t contact, const HullCollision& collision);

/// Whether no point of a manifold touched when contacts were prepared last.
bool isApart(const WorldState& state, const Contact& contact);
/// Has a manifold collided again in the next findManifolds().
void outdateManifold(WorldState& state, const Contact& contact);

/// The collision of a contact.
struct ContactCollision {
    std::uint32_t contact;
    HullCollision collision;
};

/// Memory reused from step to step.
struct NarrowPhaseScratch {
    std::vector<std::vector<ContactCollision>> stale;      // by region
    std::vector<std::vector<ContactCollision>> separated;  // by chunk
    std::vector<const ContactCollision*> all;              // by ascending contact
};

/// Updates outdated manifolds, begins contacts of pairs that came near and ends those of pairs that separated. With
/// `newOnly`, only contacts that were never collided. Returns the number of contacts collided.
int findManifolds(WorldState& state, ThreadPool& threads, const Regions& regions, NarrowPhaseScratch& scratch,
                  const SolverKernels& kernels, const SolverStep& step, bool newOnly);

}  // namespace rubble
