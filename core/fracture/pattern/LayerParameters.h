#pragma once

#include "core/fracture/kinds/BlueNoise.h"
#include "core/fracture/kinds/BrickBond.h"
#include "core/fracture/kinds/Clusters.h"
#include "core/fracture/kinds/CrackLines.h"
#include "core/fracture/kinds/DensityImage.h"
#include "core/fracture/kinds/Grain.h"
#include "core/fracture/kinds/HexagonalLattice.h"
#include "core/fracture/kinds/ImpactScatter.h"
#include "core/fracture/kinds/JitteredGrid.h"
#include "core/fracture/kinds/LloydRelaxation.h"
#include "core/fracture/kinds/PlacedSeeds.h"
#include "core/fracture/kinds/RadialCracks.h"
#include "core/fracture/kinds/RadialPattern.h"
#include "core/fracture/kinds/Slices.h"
#include "core/fracture/kinds/SurfaceScatter.h"
#include "core/fracture/kinds/UniformScatter.h"
#include "core/fracture/kinds/WeightedLloyd.h"

#include <variant>

namespace rubble {

/// The parameters of a layer: one struct per kind, see LayerKind.h. Hashes contain the index of a kind: append new
/// kinds at the end.
using LayerParameters = std::variant<UniformScatter, BlueNoise, PlacedSeeds, LloydRelaxation, JitteredGrid, Clusters,
                                     RadialPattern, ImpactScatter, DensityImage, BrickBond, Slices, CrackLines, Grain,
                                     WeightedLloyd, HexagonalLattice, RadialCracks, SurfaceScatter>;

}  // namespace rubble
