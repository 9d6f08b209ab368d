#pragma once

#include "core/asset/Project.h"

#include <optional>
#include <string>

namespace rubble {

/// The parts of valueFault() that look at play: how an asset is cut where it is hit and what is wanted of it, what is
/// taken away, what is done to a scene and expected of it.
std::optional<std::string> playFault(const Asset& asset);
std::optional<std::string> faultOf(const Debris& debris);
std::optional<std::string> faultOf(const Shot& shot);
std::optional<std::string> faultOf(const PlayTest& test);

}  // namespace rubble
