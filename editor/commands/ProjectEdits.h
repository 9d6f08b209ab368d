#pragma once

#include "core/play/scene/PlayInput.h"
#include "editor/document/Edit.h"

#include <span>

namespace rubble {

// Edits of a project, to be pushed into the Document. These functions only read the project.

/// Replaces the element with the value's id by the value. `mergeKey`: see Edit::mergeKey.
template <class Value>
Edit modify(const QString& text, Value value, quint64 mergeKey = 0) {
    const Id id = value.id;
    return {.text = text, .replacements = {Replacement<Value>{id, std::move(value)}}, .mergeKey = mergeKey};
}
inline Edit modify(const QString& text, const SceneSettings& scene, quint64 mergeKey = 0) {
    return {.text = text, .replacements = {scene}, .mergeKey = mergeKey};
}

/// The edit that turns one project into another: an import, for example.
Edit editBetween(const QString& text, const Project& from, const Project& to);

/// An edit that adds an element, and its id.
struct Addition {
    Edit edit;
    Id id = 0;
};

/// Adds an asset with the first material and 20 scattered seeds, and an instance of it on the ground beside the scene.
/// Its threshold is derived if the strength of the material is known. Gets a number if its name is taken.
Addition addAsset(const Project& project, const std::string& name, const Prism& prism);
/// Adds a copy of an asset, whose layers get fresh ids.
Addition duplicateAsset(const Project& project, Id asset);
/// Removes assets and everything that references them: instances, shots that throw them, and expectations on the
/// instances.
Edit removeAssets(const Project& project, std::span<const Id> assets);

/// Adds a material with the density of stone.
Addition addMaterial(const Project& project, const std::string& name);
/// Adds a copy of a material.
Addition duplicateMaterial(const Project& project, Id source);
/// Removes a material; its assets get the first of the others. Does nothing if it is the last one.
Edit removeMaterial(const Project& project, Id material);

/// Adds an instance of an asset, on the ground beside the scene.
Addition addInstance(const Project& project, Id asset);
/// Adds a copy of each instance, displaced by `by` (m).
Edit duplicateInstances(const Project& project, std::span<const Id> instances, Vec3 by);
/// Removes instances and the expectations that name them.
Edit removeInstances(const Project& project, std::span<const Id> instances);

/// Adds a mortar between instances, or between all if none are given.
Addition addMortar(const Project& project, std::span<const Id> instances);
Edit removeMortar(Id mortar);

/// Adds a shot that is fired half a second after the start. Gets a number if its name is taken.
Addition addShot(const Project& project, const std::string& name, const ShotAction& action);

/// Adds a play-test. With a shot, which is also added, it expects something to break; without one, everything to stay
/// intact.
Addition addPlayTest(const Project& project, const std::optional<ShotInput>& shot);
Edit removePlayTest(Id test);

/// Adds a layer with its own random seed to the end of the asset's pattern with this index (see AssetPatterns.h). In a
/// new asset it takes the place of the seeds that are scattered there, unless it needs them or adds to them by hand.
Addition addLayer(const Project& project, Id asset, const LayerParameters& parameters, std::size_t pattern = 0);
/// Adds a level that fractures the leaf fragments of an asset, each with a few scattered seeds.
Edit addLevel(const Project& project, Id asset);

}  // namespace rubble
