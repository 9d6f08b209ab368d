#pragma once

#include "core/play/Replay.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace rubble {

/// The version of the replay files that are written and read.
inline constexpr std::uint32_t kReplayVersion = 1;

/// What a replay says it is of: a hash of the project's file as projectText() writes it.
ContentHash projectHash(const Project& project);

/// A replay as JSON: inputs as they were given, a step a line, and a seal over each part. docs/formats/replay.md tells every
/// field.
std::string replayText(const Replay& replay);

/// Reads what replayText() wrote, bit for bit.
///
/// Errors: BadInput where the text is not such JSON, naming the place, or where a part is not what was sealed, naming the part;
/// Unsupported where its version is newer; Limit where it is too large.
Result<Replay> readReplayText(std::string_view json);

/// Reads and writes a replay file, as a whole or not at all. Errors: those of readFile() and readReplayText(), of
/// writeFileAtomically(), with the path.
Result<Replay> loadReplay(const std::filesystem::path& path);
Status saveReplay(const std::filesystem::path& path, const Replay& replay);

}  // namespace rubble
