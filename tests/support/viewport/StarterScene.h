#pragma once

#include "core/asset/library/StarterProject.h"
#include "viewport/scene/SceneBuilder.h"

#include <memory>

namespace rubble::test {

/// The starter project's wall, baked, in a plain colour.
inline std::shared_ptr<const RenderScene> starterScene(const SceneMarks& marks = {}) {
    Project project = starterProject();
    project.materials[0].finish = Finish::Plain;
    AssetBakes bakes;
    bakes[{project.assets[0].id}] = std::make_shared<const Bake>(bake(project.assets[0]).value());
    return std::make_shared<const RenderScene>(sceneOf(project, bakes, {.marks = marks}));
}

}  // namespace rubble::test
