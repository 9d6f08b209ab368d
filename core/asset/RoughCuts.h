#pragma once

#include "core/asset/Shaping.h"
#include "core/fracture/Fragment.h"

#include <vector>

namespace rubble {

/// The corners to be put into each edge of a fragment so that its cuts are rough, in the fragment's frame: one list an edge, ring after
/// ring as Fragment::across() has them. No corners where an edge is not a cut, or shorter than two bumps' steps.
///
/// Fragments on either side of a cut get the same points bit for bit, before either subtracts its centre. A corner is displaced across
/// its edge by at most a share of how far it is from all other edges of the two pieces, less a step: rough edges of a piece
/// meet nowhere but in their ends, which stay, and outlines stay what they are. Beside a gap each fragment is
/// rough by itself, and stands out by less than half of it.
///
/// `gap`: that of the fragments. O(corners of the two pieces · steps) an edge.
std::vector<std::vector<Vec2>> roughCorners(const Fragment& fragment, const Roughness& roughness, double gap);

/// Value noise in [-1, 1], seeded: octaves of a smoothed lattice, each half as high and twice as fine as the one before.
/// `place` is in bumps of the first octave.
double fractalNoise(Vec2 place, std::uint32_t octaves, std::uint64_t randomSeed);

}  // namespace rubble
