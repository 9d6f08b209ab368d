#pragma once

#include "core/asset/project/Project.h"
#include "viewport/scene/Camera.h"
#include "viewport/scene/RenderScene.h"

#include <memory>

namespace rubble {

/// A block of a material that has lost a corner, so that its outside and its inside can be seen. Takes a few ms.
std::shared_ptr<const RenderScene> materialSample(const Material& material);

/// A camera that looks at the broken corner of a sample and frames all of it.
Camera sampleCamera(const RenderScene& sample, ImageSize size);

}  // namespace rubble
