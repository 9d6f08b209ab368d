#pragma once

#include "core/physics/state/StepResults.h"
#include "core/play/breaking/BrokenBonds.h"

#include <optional>
#include <span>

namespace rubble {

/// The structure of a body with bonds, whether or not any is damaged.
std::shared_ptr<const PlayStructure> knownStructure(const SessionParts& parts, const PlayBody& body);

/// Breaks the bonds of bodies that are hit in a step whose collisions are known, by the simple rule, and splits them.
/// What the bonds took is an impulse between the body and its impactor. True if any body came free.
bool breakHitBonds(SessionParts& parts, std::span<const Impact> impacts);

/// Breaks all bonds of a body that can break; with clusters, those of the level at which it breaks.
void breakAllBonds(SessionParts& parts, PlayBody& body);

/// Damages and breaks bonds of a body by an impulse, N·s, at points in the world, and adds the hit to the impacts of
/// the step. The body stays as it is: the result is for splitBodies(), if bonds broke. `level`: at which it breaks;
/// none: that of heldClusters().
BrokenBonds damageBonds(SessionParts& parts, PlayBody& body, std::span<const Vec3> points, double impulse,
                        std::optional<ClusterLevel> level = {});

/// Damages and breaks the bonds within a blast by its impulse per area there, and splits their bodies.
void blastBonds(SessionParts& parts, Vec3 origin, const Blast& blast);

}  // namespace rubble
