#pragma once

#include "viewport/scene/AssetModel.h"

#include <vector>

namespace rubble {

/// The mean strength of the bonds of each solid of a model, N·s/m², weighted by their areas: that of the asset as it
/// is in the project now, without the factor of an instance. Infinite where none can break; NaN for solids without
/// bonds and assets that do not break as bonded. The model has its bonds.
std::vector<double> bondStrengths(const AssetModel& model, const Project& project);

}  // namespace rubble
