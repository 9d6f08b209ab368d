#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/play/session/SessionTracks.h"

#include <filesystem>

namespace rubble {

/// Whether the name of a file is that of an animation: it ends in ".glb" or ".usda", in upper or lower case.
///
/// Errors: BadInput, with the path.
Status checkAnimationPath(const std::filesystem::path& path);

/// Writes the tracks of a session of `project` as an animation, in the format that the name of the file says, each file
/// atomically: those of USD have the images of textured materials beside them. The scene is called as the file. See
/// docs/formats/animation.md.
///
/// Errors: those of checkAnimationPath(), animatedScene(), glbAnimation() and writeFileAtomically().
Status saveAnimation(const std::filesystem::path& path, const Project& project, const SessionTracks& tracks,
                     const TaskContext& task = {});

}  // namespace rubble
