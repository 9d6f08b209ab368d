#pragma once

#include "core/base/TaskContext.h"

#include <filesystem>
#include <optional>

namespace rubble {

/// Returns whether a path is that of a video, by its suffix: .mp4, .mkv, .mov or .webm.
bool isVideoPath(const std::filesystem::path& path);

/// Returns the path of ffmpeg, if it is installed in a folder of PATH.
std::optional<std::filesystem::path> findFfmpeg();

/// Fails if a video cannot be written to a path because something is there that is protected or no file. Rendering
/// takes long: better before it than after.
///
/// Errors: Io, with the path and the reason.
Status checkVideoReplaceable(const std::filesystem::path& video);

/// Encodes the PictureSequence in a folder as a video with `rate` pictures per second in a widely supported format.
/// Replaces an existing video atomically, with its permissions and group, and its owner where the user may give files
/// away; a link to a video stays one. Odd widths and heights are padded by a pixel. The sound, if there is one, is that
/// of a WAV file.
///
/// Errors: NotFound without ffmpeg; Io with the message of ffmpeg or the system; Cancelled.
Status encodeVideo(const std::filesystem::path& pictures, double rate, const std::filesystem::path& video,
                   const TaskContext& task = {}, const std::optional<std::filesystem::path>& sound = {});

}  // namespace rubble
