#pragma once

#include "core/asset/project/Project.h"
#include "core/base/Hash.h"

namespace rubble {

/// A hash of everything that bake() depends on; the asset's name is not part of it.
ContentHash bakeInputHash(const Asset& asset);

}  // namespace rubble
