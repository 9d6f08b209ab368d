#pragma once

#include "core/asset/project/Surface.h"

#include <optional>
#include <string>

namespace rubble {

/// The first number of a surface that is out of range, or the first material that is missing, as a sentence about its
/// owner, `Asset 2 "gate"`.
std::optional<std::string> surfaceFault(const std::string& owner, const Surface& surface);

}  // namespace rubble
