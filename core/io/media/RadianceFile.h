#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/base/image/RadianceImage.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace rubble {

/// The largest width of a sky file in pixels; its height is half of it.
inline constexpr std::uint32_t kMaxSkyFileWidth = 16384;

/// Reads a Radiance picture (.hdr) of a whole sky: RGBE pixels, plain or with either kind of run-length encoding, in
/// each of the eight orientations. Reduced by whole pixels to RadianceImage::kMaxWidth; radiance is in the file's unit,
/// with its exposure undone.
///
/// Errors, with `name`, the place and what to do: Unsupported for other formats, colours and proportions; Limit above
/// kMaxSkyFileWidth; BadInput if the file is damaged, truncated or goes on after its last pixel; Cancelled.
/// Source: Ward, "Real pixels", 1991; Ward, "The Radiance picture file format", 1997.
Result<RadianceImage> radianceOfFile(std::string_view bytes, const std::string& name, const TaskContext& task = {});

/// Errors: those of readFile() and radianceOfFile().
Result<RadianceImage> loadRadiance(const std::filesystem::path& path, const TaskContext& task = {});

}  // namespace rubble
