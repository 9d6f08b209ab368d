#pragma once

#include "viewport/scene/Camera.h"

#include <optional>
#include <string>

namespace rubble {

/// The size that "1280x720" tells; nothing where it is no size that a picture can have.
std::optional<PictureSize> pictureSizeOf(const std::string& text);

/// A camera turned to what "front", "iso" or "30,20" (azimuth and elevation in degrees) tells; nothing where it tells no
/// view.
std::optional<Camera> cameraOf(const std::string& text);

/// The words that cameraOf() knows, as "front, back, ...".
std::string viewWords();

}  // namespace rubble
