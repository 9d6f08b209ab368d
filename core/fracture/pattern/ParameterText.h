#pragma once

#include "core/fracture/pattern/LayerParameter.h"

#include <string>

namespace rubble {

/// A parameter's value as text: "20", "0.3 m", "8 a square metre", "(0.5, 1) m", "outline".
std::string parameterText(const LayerParameter& parameter, const LayerParameters& of);

/// Parts of such texts.
std::string unitText(Quantity quantity);  // " m", with the space before it
std::string pointText(Vec2 point);
std::string countText(const SeedCount& count);

}  // namespace rubble
