#pragma once

#include "core/fracture/LayerParameter.h"

#include <string>

namespace rubble {

/// A parameter's value in words: "20", "0.3 m", "8 a square metre", "(0.5, 1) m", "outline".
std::string parameterText(const LayerParameter& parameter, const LayerParameters& of);

/// The parts of it that other sentences are made of.
std::string unitText(Quantity quantity);  // " m", with the space before it
std::string pointText(Vec2 point);
std::string countText(const SeedCount& count);

}  // namespace rubble
