#pragma once

#include "core/asset/project/Project.h"

#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// The first number out of range, or the first prism or pattern that cannot be used, as a sentence; the part of
/// verifyProject() that checks values.
std::optional<std::string> valueFault(const Project& project);
/// The first such fault of each element, of each derived threshold and of the scene.
std::vector<std::string> valueFaults(const Project& project);

/// The same for one element. Those of shots, play-tests and debris are in PlayFaults.h, that of mortars in
/// BondFaults.h.
std::optional<std::string> faultOf(const Material& material);
/// Without the surface (see surfaceFault()) and the derived threshold.
std::optional<std::string> faultOf(const Asset& asset);
std::optional<std::string> faultOf(const Instance& instance);
/// The same for ground, gravity, damage, debris and events.
std::optional<std::string> sceneFault(const Project& project);
/// The same for the threshold that follows from the material of an asset: valid numbers can give one out of range.
std::optional<std::string> thresholdFault(const Asset& asset, const Material& material);

}  // namespace rubble
