#pragma once

#include "core/play/session/Replay.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace rubble {

/// The version of replay files that is written and read.
inline constexpr std::uint32_t kReplayVersion = 1;

/// Returns the hash that identifies a replay's project: that of projectText().
ContentHash projectHash(const Project& project);

/// Returns a replay as JSON: the inputs, one step per line, the keyframes, and a checksum of each list. All fields are
/// described in docs/formats/replay.md.
std::string replayText(const Replay& replay);

/// Reads what replayText() wrote, bit for bit.
///
/// Errors: BadInput if the text is not JSON of this form, with the path, or if a list does not match its checksum;
/// Unsupported if its version is newer; Limit if it is too large.
Result<Replay> readReplayText(std::string_view json);

/// Load a replay file, and save one atomically.
///
/// Errors, with the path: those of readFile() and readReplayText(); those of writeFileAtomically().
Result<Replay> loadReplay(const std::filesystem::path& path);
Status saveReplay(const std::filesystem::path& path, const Replay& replay);

}  // namespace rubble
