#pragma once

#include "core/io/json/JsonDocument.h"
#include "core/play/session/Replay.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace rubble {

/// The version of replay files that is written; versions 1, without velocities and breaks,
/// and 2, without events, are read as well.
inline constexpr std::uint32_t kReplayVersion = 3;

/// Returns the hash that identifies a replay's project: that of projectText().
ContentHash projectHash(const Project& project);
/// Returns the hash that identifies a state's scene: that of the project without its saved throws, tests, requirements
/// and settings of events, which a state outlives.
ContentHash sceneHash(Project project);

/// Returns a replay as JSON: the inputs, one step per line, the keyframes, and the seals of each list. All fields are
/// described in docs/formats/replay.md.
std::string replayText(const Replay& replay);

/// Reads what replayText() wrote, bit for bit.
///
/// Errors: BadInput if the text is not JSON of this form, or with the first input, step or keyframe that does not match
/// its seal, each with its path; Unsupported if its version is newer; Limit if it is too large.
Result<Replay> readReplayText(std::string_view json);

/// Load a replay file, and save one atomically.
///
/// Errors, with the path: those of readFile() and readReplayText(); those of writeFileAtomically(), and Limit where the
/// text is too large to be read back.
Result<Replay> loadReplay(const std::filesystem::path& path);
Status saveReplay(const std::filesystem::path& path, const Replay& replay, std::size_t maxSize = kMaxJsonSize);

/// Follows the size of a recording while it is made, so that it can be ended before it is too large to be read back.
class ReplaySize {
public:
    explicit ReplaySize(std::size_t maxSize = kMaxJsonSize) : m_maxSize(maxSize) {}

    /// Must be called after each step of the recording.
    ///
    /// Errors: Limit, with the steps that fit.
    Status add(const Replay& replay);
    /// At least the size of replayText(), in bytes.
    std::size_t bytes() const { return m_bytes; }

private:
    std::size_t m_maxSize;
    std::size_t m_bytes = 4096;  // of what is beside the lists
    std::size_t m_inputs = 0;    // counted so far
    std::size_t m_keyframes = 0;
};

}  // namespace rubble
