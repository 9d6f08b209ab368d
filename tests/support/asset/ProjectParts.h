#pragma once

#include "core/asset/project/Project.h"

#include <string>
#include <utility>
#include <vector>

namespace rubble::test {

/// Adds a material with the project's next id.
inline Id addMaterial(Project& project, Material material) {
    material.id = project.nextId++;
    project.materials.push_back(std::move(material));
    return project.materials.back().id;
}

/// A pattern of these layers, in this order. A layer's random seed is its id.
inline Pattern patternOf(Project& project, std::vector<LayerParameters> layers) {
    Pattern pattern;
    for (LayerParameters& parameters : layers) {
        const Id id = project.nextId++;
        pattern.layers.push_back({.id = id, .randomSeed = id, .parameters = std::move(parameters)});
    }
    return pattern;
}

/// Adds an asset with these layers.
inline Id addAsset(Project& project, Asset asset, std::vector<LayerParameters> layers) {
    asset.id = project.nextId++;
    asset.pattern = patternOf(project, std::move(layers));
    project.assets.push_back(std::move(asset));
    return project.assets.back().id;
}

inline void addInstance(Project& project, Id asset, const std::string& name, const Pose& pose) {
    project.instances.push_back({.id = project.nextId++, .name = name, .asset = asset, .pose = pose});
}

inline Id addShot(Project& project, const std::string& name, double time, const ShotAction& action) {
    project.shots.push_back({.id = project.nextId++, .name = name, .time = time, .action = action});
    return project.shots.back().id;
}

inline void addPlayTest(Project& project, PlayTest test) {
    test.id = project.nextId++;
    project.playTests.push_back(std::move(test));
}

}  // namespace rubble::test
