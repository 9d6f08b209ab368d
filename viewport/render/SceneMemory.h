#pragma once

#include "viewport/scene/RenderScene.h"

namespace rubble {

/// Whether there is the memory to draw a scene in software whose geometry is new.
bool isMemoryLeftFor(const RenderScene& scene);

}  // namespace rubble
