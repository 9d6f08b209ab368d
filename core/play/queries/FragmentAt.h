#pragma once

#include "core/play/scene/PlayBody.h"

#include <optional>

namespace rubble {

/// The fragment that is bonded in a body of a world and nearest to a point, m, of the world; of equally near ones, the
/// lowest. Nothing for a body without bonds. O(corners of its fragments).
std::optional<std::uint32_t> fragmentAt(const World& world, const PlayBody& body, Vec3 point);

}  // namespace rubble
