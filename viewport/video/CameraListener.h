#pragma once

#include "core/sound/mix/SoundCue.h"
#include "viewport/scene/Camera.h"

namespace rubble {

/// Who sees the picture of a camera hears what it shows from the eye.
Listener listenerAt(const Camera& camera);

}  // namespace rubble
