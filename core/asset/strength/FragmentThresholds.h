#pragma once

#include "core/asset/project/FragmentPath.h"
#include "core/asset/project/Project.h"

#include <cstdint>
#include <optional>

namespace rubble {

/// The threshold that is set for this fragment alone, N·s.
std::optional<double> ownThreshold(const Asset& asset, const FragmentPath& fragment);
/// The threshold that is set for a fragment, N·s: its own, or that of the level which fractures it. Nothing if it
/// follows from its volume, see thresholdScaleOf(), or if the fragment is not fractured.
std::optional<double> fragmentThreshold(const Asset& asset, const FragmentPath& fragment, std::uint32_t level);

/// The threshold of a fragment for which none is set, relative to that of the whole, by its fraction of the whole's
/// volume: the fraction to the power of 2/3, since breaking energy scales with area.
double thresholdScaleOf(double volumeFraction);

}  // namespace rubble
