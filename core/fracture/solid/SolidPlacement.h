#pragma once

#include "core/fracture/solid/InnerFaces.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Moves points of a cut solid from where they are between seeds on the lattice to where they are between the seeds as
/// given: the last digits are then those of the input. One that would move by more than kTieDistance, since its planes
/// are nearly parallel, stays.
///
/// `corners`: of the mesh as given; `sites`: as given, by site; `placed`: of each point, as solidPoints() gives them.
/// All in steps.
void placeBetweenSeeds(const LatticeMesh& mesh, std::span<const Vec3> corners, std::span<const Vec3> sites,
                       const SolidDiagram& diagram, const SurfacePieces& pieces, const InnerFaces& facets,
                       std::span<Vec3> placed);

/// Moves points that stand for several of the surface to where all of these are on it: to the common edge or corner of
/// their triangles, so that the surface stays as it is.
///
/// `corners`: of the mesh as given; `welded`: the point that stands for each; `placed`: of each point. All in steps.
void placeOnSurface(const LatticeMesh& mesh, std::span<const Vec3> corners, const SurfacePieces& pieces,
                    std::span<const std::uint32_t> welded, std::span<Vec3> placed);

}  // namespace rubble
