#pragma once

#include "core/play/scene/PlayScene.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// The nodes of a structure that anchors hold farther away than its span at the start, ascending. They stay until they
/// lose what support they have.
std::vector<std::uint32_t> nodesBeyondSpan(const PlayStructure& structure);

/// What an artist should know of the support in a scene, by instance in the project's order: BeyondSpan for one with
/// such nodes, at the farthest of them; WeakBonds for one with hangingLoads() beyond what the bonds take, at the one
/// that is farthest beyond it.
std::vector<Diagnostic> supportProblems(const PlayScene& scene);

/// Whether a diagnostic is one of support in a scene: one of those, or IdleMortar.
bool isOfSupport(const Diagnostic& diagnostic);

/// Whether a project has what sceneProblems() looks at.
bool mayHaveSceneProblems(const Project& project);

/// The problems of a project that only show in its scene, those of isOfSupport(). None where the project
/// cannot be played yet, or nothing in it is held by bonds. As long as playScene() takes.
std::vector<Diagnostic> sceneProblems(const Project& project, const AssetBakes& bakes, const TaskContext& task = {});

}  // namespace rubble
