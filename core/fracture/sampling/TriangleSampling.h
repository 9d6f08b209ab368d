#pragma once

#include "core/base/Random.h"
#include "core/geometry/predicates/Vec.h"

#include <cstddef>
#include <span>

namespace rubble {

/// A random index by weight, from one random number. `sums` has the weights' cumulative sums, at least one.
std::size_t drawByWeight(std::span<const double> sums, Random& random);

/// A uniform random point of the triangle with a corner and the two sides from it, from two random numbers.
Vec2 pointOfTriangle(Vec2 corner, Vec2 first, Vec2 second, Random& random);

}  // namespace rubble
