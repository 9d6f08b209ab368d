#pragma once

#include "core/asset/project/Project.h"

#include <optional>
#include <string>

namespace rubble {

/// The minimum distance from the start of a throw to its aim, m: far above rounding of coordinates, and its square is
/// far above zero.
inline constexpr double kMinThrowLength = 1e-6;

/// The parts of valueFault() for play: fracture at the impact, strength requirements, debris, shots and play-tests.
std::optional<std::string> playFault(const Asset& asset);
std::optional<std::string> faultOf(const Debris& debris);
std::optional<std::string> faultOf(const EventSettings& events);
std::optional<std::string> faultOf(const Shot& shot);
std::optional<std::string> faultOf(const PlayTest& test);

}  // namespace rubble
