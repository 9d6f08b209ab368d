#include "app/cli/options/AnimationOptions.h"

#include "app/cli/options/CommonOptions.h"
#include "core/asset/project/Ranges.h"

namespace rubble {

void addAnimationOptions(Command& command, AnimationOptions& options) {
    const CommandOption animation =
        command
            .option("--animation", options.file,
                    "Write the motion of all fragments, for any 3D program: FILE.glb or FILE.usda")
            .writes({".glb", ".usda"})
            .valueName("FILE");
    command.option("--every", options.every, "Steps between the frames of the animation (default: 1)")
        .wholeInRange(ProjectNumber::Steps)
        .needs(animation)
        .valueName("K");
}

Status checkAnimation(const AnimationOptions& options) {
    return options.file.empty() ? success() : checkAnimationPath(options.file);
}

std::optional<TrackRecorder> recorderFor(const AnimationOptions& options, const Session& session) {
    if (options.file.empty()) return std::nullopt;
    return TrackRecorder(session, static_cast<std::uint64_t>(options.every));
}

}  // namespace rubble
