#pragma once

#include "core/base/TaskContext.h"

#include <filesystem>
#include <optional>

namespace rubble {

/// Whether a path names a film, by its suffix: .mp4, .mkv, .mov or .webm.
bool isFilmPath(const std::filesystem::path& path);

/// The program that makes films of pictures, where it is installed: ffmpeg, in one of the folders of PATH.
std::optional<std::filesystem::path> ffmpegProgram();

/// Makes a film of a folder's PictureSequence, so many pictures a second, that every player shows. It is there as a whole or not
/// at all; a film that was there is replaced. Sides of an odd number of pixels become one pixel longer.
///
/// Errors: NotFound where there is no ffmpeg; Io with what ffmpeg or the system says; Cancelled.
Status encodeFilm(const std::filesystem::path& pictures, double rate, const std::filesystem::path& film,
                  const TaskContext& task = {});

}  // namespace rubble
