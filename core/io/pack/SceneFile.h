#pragma once

#include "core/asset/project/Project.h"
#include "core/io/pack/PackExport.h"
#include "core/play/scene/PlayScene.h"

#include <string>

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

}  // namespace rubble
