#pragma once

#include "core/asset/Project.h"

#include <optional>
#include <string>

namespace rubble {

/// The parts of valueFault() that look at what is done to a scene and expected of it.
std::optional<std::string> faultOf(const Shot& shot);
std::optional<std::string> faultOf(const PlayTest& test);

}  // namespace rubble
