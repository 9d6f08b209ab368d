#include "viewport/video/CameraListener.h"

namespace rubble {

Listener listenerAt(const Camera& camera) { return {.position = eyeOf(camera), .right = axesOf(camera).right}; }

}  // namespace rubble
