#pragma once

#include "viewport/scene/Camera.h"

#include <optional>
#include <string>

namespace rubble {

/// Parses a size such as "1280x720"; nullopt if it is not a valid one.
std::optional<ImageSize> parsePictureSize(const std::string& text);

/// Parses a view such as "front", "iso" or "30,20" (azimuth and elevation in degrees); nullopt if it is not a valid
/// one.
std::optional<Camera> parseCamera(const std::string& text);

/// The names that parseCamera() accepts: "front, back, ...".
std::string viewWords();

}  // namespace rubble
