#pragma once

#include "core/play/scene/PlayScene.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// The nodes of a structure that anchors hold farther away than its span at the start, ascending. They stay until they
/// lose what support they have.
std::vector<std::uint32_t> nodesBeyondSpan(const PlayStructure& structure);

/// What an artist should know of the support in a scene: BeyondSpan for each instance with such nodes, in the
/// project's order, at the farthest of them.
std::vector<Diagnostic> supportProblems(const PlayScene& scene);

/// Whether a project has what sceneProblems() looks at.
bool mayHaveSceneProblems(const Project& project);

/// The problems of a project that only show in its scene: IdleMortar, and supportProblems(). None where the project
/// cannot be played yet, or nothing in it is held by bonds. As long as playScene() takes.
std::vector<Diagnostic> sceneProblems(const Project& project, const AssetBakes& bakes, const TaskContext& task = {});

}  // namespace rubble
