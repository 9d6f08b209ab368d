#pragma once

#include "core/asset/bake/Bake.h"

#include <optional>
#include <string>

namespace rubble {

/// Checks every stage of a bake: see core/fracture/verify. The first fault as a sentence, or nothing.
std::optional<std::string> verifyBake(const Bake& bake, const Asset& asset);

}  // namespace rubble
