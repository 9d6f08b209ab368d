#pragma once

#include "core/asset/project/FragmentPath.h"
#include "core/asset/project/Project.h"

#include <cstdint>

namespace rubble {

/// The level by which a fragment is fractured: its own setting, or the setting of its level. Null if it is not
/// fractured.
const Level* levelFor(const Asset& asset, const FragmentPath& fragment, std::uint32_t level);

}  // namespace rubble
