#pragma once

#include "core/asset/bake/Bake.h"

#include <optional>

namespace rubble {

/// The number of the fragment with a path, kNone for the whole; nothing if the bake has no such fragment.
/// O(siblings of the fragment and of its ancestors).
std::optional<std::uint32_t> fragmentAt(const Bake& bake, const FragmentPath& path);

}  // namespace rubble
