#pragma once

#include "core/asset/strength/Threshold.h"
#include "core/base/Random.h"
#include "core/fracture/pattern/SeedEdits.h"
#include "core/geometry/polygon/OutlineShapes.h"
#include "core/io/project/MaterialPresetFile.h"
#include "editor/commands/FragmentEdits.h"
#include "editor/commands/MaterialEdits.h"
#include "editor/commands/ProjectEdits.h"

namespace rubble {

/// A random edit of a project, as a user may make it.
inline Edit randomEdit(const Project& project, Random& random, quint64 mergeKey) {
    const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random.below(count)); };
    const std::size_t kind = below(16);
    if (project.assets.empty() || kind == 0) {
        return addAsset(project, "wall", {rectangleOutline(1.0 + random.unit(), 2.0), 0.5}).edit;
    }
    Asset asset = project.assets[below(project.assets.size())];
    switch (kind) {
        case 1: return duplicateAsset(project, asset.id).edit;
        case 2: return removeAssets(project, std::vector{asset.id});
        case 3: return addMaterial(project, "stone").edit;
        case 4: return removeMaterial(project, project.materials[below(project.materials.size())].id);
        case 5: return addInstance(project, asset.id).edit;
        case 6: return addLayer(project, asset.id, PlacedSeeds{{{0, {0.1, 0.1}}}}).edit;
        case 7:
            if (project.instances.empty()) return {};
            return removeInstances(project, std::vector{project.instances[below(project.instances.size())].id});
        case 8: {
            SceneSettings scene = sceneSettings(project);
            scene.ground.height = random.unit();
            return modify("Move ground", scene, mergeKey);
        }
        case 9:
            asset.shaping.gap = 0.01 * random.unit();
            asset.shaping.smallPieces.rule = random.below(2) == 0 ? SmallPieceRule::Merge : SmallPieceRule::DropSeeds;
            return modify("Shape pieces", std::move(asset), mergeKey);
        case 10:
        case 11: {
            const std::string id = std::to_string(asset.pattern.layers[0].id) + ".";
            const std::vector<SelectedFragment> pieces{{.path = id + "0", .area = 2.0},
                                                       {.path = id + "1", .area = 1.0}};
            return kind == 10 ? mergeFragments(project, asset.id, pieces) : splitFragments(project, asset.id, pieces);
        }
        case 12: {
            Material material = project.materials[below(project.materials.size())];
            material.tensileStrength.reset();
            if (random.below(3) > 0) material.tensileStrength = 1e5 + 1e7 * random.unit();
            return modify("Set tensile strength", std::move(material), mergeKey);
        }
        case 13:
            asset.threshold = thresholdOf(project, asset);  // as the inspector does: it stays what it was
            asset.contactTime.reset();
            if (random.below(3) > 0) asset.contactTime = 1e-4 + 1e-2 * random.unit();
            return modify("Set where the threshold comes from", std::move(asset), mergeKey);
        case 14: {
            static const MaterialLibrary kLibrary = materialLibrary();
            return applyPreset(project, asset.id, kLibrary.materials[below(kLibrary.materials.size())].preset,
                               {.appliesPattern = random.below(2) == 0, .derivesThreshold = random.below(2) == 0});
        }
        default: {
            const PatternLayer& layer = asset.pattern.layers[below(asset.pattern.layers.size())];
            moveSeed(asset.pattern, {layer.id, 0}, {random.unit(), random.unit()});
            return modify("Move seed", std::move(asset), mergeKey);
        }
    }
}

}  // namespace rubble
