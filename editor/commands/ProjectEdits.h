#pragma once

#include "core/play/PlayInput.h"
#include "editor/document/Edit.h"

#include <span>

namespace rubble {

/// The edits that an editor makes of a project: each gives what to push into the Document. They read the project only.

/// Another value for a thing that is there, with the value's id. `stroke`: see Edit::stroke.
template <class Value>
Edit altered(const QString& text, Value value, quint64 stroke = 0) {
    const Id id = value.id;
    return {.text = text, .swaps = {Swap<Value>{id, std::move(value)}}, .stroke = stroke};
}
inline Edit altered(const QString& text, const SceneSettings& scene, quint64 stroke = 0) {
    return {.text = text, .swaps = {scene}, .stroke = stroke};
}

/// What turns one project into another: an import, say.
Edit editBetween(const QString& text, const Project& from, const Project& to);

/// An edit that adds a thing, and its id.
struct Addition {
    Edit edit;
    Id id = 0;
};

/// Adds an asset of the first material, scattered with 20 seeds, and an instance of it standing on the ground beside what
/// is in the scene. The name is numbered where it is taken.
Addition addAsset(const Project& project, const std::string& name, const Prism& prism);
/// Adds a copy of an asset, its layers under ids of their own.
Addition duplicateAsset(const Project& project, Id asset);
/// Removes assets with all that speaks of them: their instances, the shots that throw them, expectations on their instances.
Edit removeAssets(const Project& project, std::span<const Id> assets);

/// Adds a material of usual stone.
Addition addMaterial(const Project& project, const std::string& name);
/// Adds a copy of a material.
Addition duplicateMaterial(const Project& project, Id source);
/// Removes a material; assets of it take the first of the others. Nothing where it is the last one.
Edit removeMaterial(const Project& project, Id material);

/// Adds an instance of an asset, standing on the ground beside what is in the scene.
Addition addInstance(const Project& project, Id asset);
/// Adds a copy of each instance, moved along.
Edit duplicateInstances(const Project& project, std::span<const Id> instances, Vec3 by);
/// Removes instances and the expectations that name them.
Edit removeInstances(const Project& project, std::span<const Id> instances);

/// Adds a shot that is fired half a second after the start. The name is numbered where it is taken.
Addition addShot(const Project& project, const std::string& name, const ShotAction& action);

/// Adds a play-test: of a shot, which is kept, too, that something breaks; without one that everything stands.
Addition addPlayTest(const Project& project, const std::optional<ShotInput>& shot);
Edit removePlayTest(Id test);

/// Adds a layer at the end of an asset's pattern, or of that of a level (1: its first), with a random seed of its own.
Addition addLayer(const Project& project, Id asset, const LayerParameters& parameters, std::size_t level = 0);
/// Adds a level that breaks the smallest fragments of an asset so far again, each with a few scattered seeds.
Edit addLevel(const Project& project, Id asset);

}  // namespace rubble
