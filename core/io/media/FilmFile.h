#pragma once

#include "core/base/TaskContext.h"

#include <filesystem>
#include <optional>

namespace rubble {

/// Returns whether a path is that of a film, by its suffix: .mp4, .mkv, .mov or .webm.
bool isFilmPath(const std::filesystem::path& path);

/// Returns the path of ffmpeg, if it is installed in a folder of PATH.
std::optional<std::filesystem::path> findFfmpeg();

/// Encodes the PictureSequence in a folder as a film with `rate` pictures per second in a widely supported format.
/// Replaces an existing film atomically. Odd widths and heights are padded by a pixel.
///
/// Errors: NotFound without ffmpeg; Io with the message of ffmpeg or the system; Cancelled.
Status encodeFilm(const std::filesystem::path& pictures, double rate, const std::filesystem::path& film,
                  const TaskContext& task = {});

}  // namespace rubble
