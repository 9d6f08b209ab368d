#pragma once

#include "core/asset/bake/Bake.h"

#include <optional>
#include <string>

namespace rubble {

/// Checks the render meshes of the whole and of every fragment with verifyMesh(), and that their volumes add up. The
/// first fault as a sentence, or nothing.
std::optional<std::string> verifyMeshes(const Bake& bake, const Asset& asset);

}  // namespace rubble
