#pragma once

#include "core/asset/project/Project.h"
#include "core/io/pack/PackExport.h"
#include "core/play/scene/PlayScene.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace rubble {

/// The file in an output folder that says where the packs stand.
inline constexpr const char* kSceneName = "scene.json";

/// Whether a project has anything that a scene file would hold.
bool hasScene(const Project& project);

/// Whether a scene file holds bonds: of instances to what is fixed, and between them.
bool hasSceneBonds(const Project& project);

/// A hash of everything that determines the scene file of a project: the key `source` of one with bonds.
ContentHash sceneSource(const Project& project, const PackOptions& options);

/// Returns scene.json: the packs of a project that its instances use, the instances with their poses, ground, gravity,
/// mortar and shots. All fields are described in docs/formats/scene.md. `played`: the project prepared for play, where
/// it hasSceneBonds().
std::string sceneFileJson(const Project& project, const PackOptions& options, const PlayScene* played = nullptr);

/// The `physicsHash` of packs, by the names of their folders.
using PackPhysicsHashes = std::map<std::string, std::string>;

/// Returns what does not fit between a scene file and the packs beside it, as a sentence: one that is missing or of
/// another export, or a text that is no scene; nothing if all fits.
std::optional<std::string> scenePacksFault(std::string_view json, const PackPhysicsHashes& present);

}  // namespace rubble
