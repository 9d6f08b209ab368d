#pragma once

#include "core/play/session/SavedSession.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace rubble {

inline constexpr std::uint32_t kStateVersion = 5;  // written with what is new in it only, else 4
/// A session of 8,000 bodies takes about 30 MB.
inline constexpr std::size_t kMaxStateBytes = std::size_t{1} << 30;

/// A state as the bytes of a file. `scene` is the sceneHash() of its project. All fields are described in
/// docs/formats/state.md.
std::string stateBytes(const SavedSession& saved, ContentHash scene);

/// Reads what stateBytes() wrote, also in older versions; resumedSession() checks what is in it.
///
/// Errors: BadInput for other bytes, changed ones, or a table that does not fit, with its place; or if the state is of
/// another scene, with both hashes; Unsupported for a newer version; Limit above kMaxStateBytes.
Result<SavedSession> readStateBytes(std::string_view bytes, ContentHash scene);

/// Writes a state file atomically.
///
/// Errors, with the path: those of writeFileAtomically(); Limit above kMaxStateBytes.
Status saveState(const std::filesystem::path& path, const SavedSession& saved, ContentHash scene);
Status saveState(const std::filesystem::path& path, const Session& session, StateKind kind);

/// Reads a state file of a project.
///
/// Errors, with the path: those of readFile() and readStateBytes().
Result<SavedSession> loadSavedSession(const std::filesystem::path& path, ContentHash scene);

/// The state that a test starts from, in the folder of its project; null if it starts from the scene.
///
/// Errors, with the test and the path: BadInput for a link; those of loadSavedSession().
Result<std::shared_ptr<const SavedSession>> loadStart(const PlayTest& test, const std::filesystem::path& folder,
                                                      ContentHash scene);

/// A session at the moment of a state file. See resumedSession().
///
/// Errors, with the path: those of readFile(), readStateBytes() and resumedSession().
Result<Session> loadState(const std::filesystem::path& path, std::shared_ptr<const PlayScene> scene,
                          const SessionSettings& settings = {});

}  // namespace rubble
