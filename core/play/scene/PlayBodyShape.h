#pragma once

#include "core/play/scene/PlayBody.h"

namespace rubble {

/// The shape of a body of an asset. Some of the fragments of a solid are a compound of theirs, in the asset's frame,
/// with their mass summed in their order. If held, it has mass, centre and bounds of all of them, whatever is left of
/// it, so that nothing moves when it loses fragments.
std::shared_ptr<const Shape> shapeOf(const PlayBody& body);

}  // namespace rubble
