#pragma once

#include "core/asset/project/Project.h"

#include <optional>
#include <string>

namespace rubble {

/// The first fault of an asset's bonds, as a sentence: a number out of range, a stroke without points, heights or paths
/// that do not ascend, an image that is not valid.
std::optional<std::string> bondFault(const Asset& asset);

/// The first number of a mortar that is out of its range, as a sentence. verifyProject() checks its instances.
std::optional<std::string> faultOf(const Mortar& mortar);

}  // namespace rubble
