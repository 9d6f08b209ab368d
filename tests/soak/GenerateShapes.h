#pragma once

#include "core/asset/project/Project.h"
#include "core/base/Random.h"

#include <memory>

namespace rubble::soak {

/// A number between two, each decade as likely.
double magnitudeIn(Random& random, double low, double high);
/// Whether something happens that has a probability.
bool chance(Random& random, double probability);
/// A rotation: mostly none, else by 90 degrees about an axis, or any.
Quat randomRotation(Random& random);
/// Uniform on the unit sphere.
Vec3 randomDirection(Random& random);

/// A prism of about `size`, m, around the origin: a box, plate or beam, an L, a gable, a portal, a frame, a convex or a
/// star-shaped polygon.
Prism randomPrism(Random& random, double size);

/// A closed mesh of about `size`, m, around the origin: a bumpy ellipsoid, a ring, a bar of cubes, a solid of
/// revolution such as a column or a vase, or a hollow ball; stretched, and some turned.
std::shared_ptr<const ClosedMesh> randomMesh(Random& random, double size);

/// Layers of any kinds for a prism of that size, with ids from `nextId` on.
Pattern randomPattern(Random& random, double size, Id& nextId);

}  // namespace rubble::soak
