#pragma once

#include "app/cli/options/Command.h"
#include "core/base/Result.h"
#include "core/io/animation/AnimationFile.h"

#include <optional>
#include <string>

namespace rubble {

/// The options of an animation that a simulation is written as.
struct AnimationOptions {
    std::string file;  // empty: none
    int every = 1;     // steps between its frames
};

/// Adds --animation and --every.
void addAnimationOptions(Command& command, AnimationOptions& options);

/// Whether the name of the file is that of an animation, before anything is simulated.
///
/// Errors: BadInput.
Status checkAnimation(const AnimationOptions& options);

/// A recorder of a session at its start, if an animation is to be written.
std::optional<TrackRecorder> recorderFor(const AnimationOptions& options, const Session& session);

}  // namespace rubble
