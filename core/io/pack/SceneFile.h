#pragma once

#include "core/asset/project/Project.h"
#include "core/io/pack/PackExport.h"

#include <string>

namespace rubble {

/// The file in an output folder that says where the packs stand.
inline constexpr const char* kSceneName = "scene.json";

/// Whether a project has anything that a scene file would hold.
bool hasScene(const Project& project);

/// Returns scene.json: the packs of a project that its instances use, the instances with their poses, ground, gravity,
/// mortar and shots. All fields are described in docs/formats/scene.md.
std::string sceneFileJson(const Project& project, const PackOptions& options);

}  // namespace rubble
