#pragma once

#include "core/base/TaskContext.h"
#include "viewport/render/OffscreenRenderer.h"

#include <filesystem>
#include <functional>
#include <optional>

namespace rubble {

/// Makes the pictures of a video, in order.
struct FrameSource {
    std::function<Result<Image>(OffscreenRenderer& renderer, int frame, const TaskContext& task)> frameAt;
    int frames = 1;  // at most kMaxPictures
};

/// Whether the frames of a cancelled or failed video stay on disk.
enum class Unfinished { Kept, Removed };

/// Renders frames without a display and writes them as images: see PictureSequence.
///
/// Errors: those of OffscreenRenderer, of the source and of PictureSequence; Cancelled.
Status renderFrames(const FrameSource& source, const std::filesystem::path& folder, Unfinished unfinished,
                    const TaskContext& task = {});

/// Writes the sound of a video to a folder when its frames have been rendered; no path: it has none.
using SoundSource = std::function<Result<std::optional<std::filesystem::path>>(const std::filesystem::path& folder)>;

/// The same, encoded as a video: see encodeVideo(). The images and the sound lie in a hidden folder beside it meanwhile
/// and are always removed.
///
/// Errors: those of renderFrames(), of the sound and of encodeVideo().
Status renderVideo(const FrameSource& source, double frameRate, const std::filesystem::path& video,
                   const SoundSource& sound = {}, const TaskContext& task = {});

}  // namespace rubble
