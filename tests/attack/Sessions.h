#pragma once

#include "core/play/session/Session.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rubble::attack {

/// A block that breaks, above the ground.
const std::shared_ptr<const PlayScene>& blockScene();

/// An input of each kind for blockScene(), at ascending steps.
std::vector<TimedInput> sampleInputs();

/// The fault of the outcome of a session: it must be JSON, and its diagnostics sentences.
std::optional<std::string> outcomeFault(const Session& session);

/// The fault of playing a scene with all its shots and with inputs.
std::optional<std::string> playFault(const std::shared_ptr<const PlayScene>& scene,
                                     const std::vector<TimedInput>& inputs);

}  // namespace rubble::attack
