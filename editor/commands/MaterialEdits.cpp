#include "editor/commands/MaterialEdits.h"

#include "core/asset/project/AssetShape.h"
#include "core/asset/project/Names.h"
#include "core/asset/strength/Threshold.h"

#include <QCoreApplication>

#include <algorithm>

namespace rubble {

namespace {

struct MaterialEditsTexts {
    Q_DECLARE_TR_FUNCTIONS(MaterialEdits)
};

/// The id of the material that equals a preset; adds one if there is none.
Id findOrAddMaterial(const Project& project, const MaterialPreset& preset, Edit& edit) {
    for (const Material& material : project.materials) {
        if (material == materialOf(preset, material.id)) return material.id;
    }
    const Id id = edit.allocateId(project);
    Material copy = materialOf(preset, id);
    copy.name = uniqueName(project.materials, copy.name);
    edit.replacements.push_back(Replacement<Material>{id, std::move(copy)});
    return id;
}

void applyPattern(const Project& project, const MaterialPreset& preset, Asset& asset, Edit& edit) {
    if (preset.pattern.layers.empty()) return;
    asset.pattern = patternWithin(preset, planeBoundsOf(asset), boundsOf(asset).centre().z);
    for (PatternLayer& layer : asset.pattern.layers) {
        layer.id = edit.allocateId(project);
        layer.randomSeed = layer.id;
    }
    asset.fragmentLevels.clear();
    asset.fragmentThresholds.clear();
    asset.bonding.neverBreaks.clear();
    asset.bonding.clusters.clear();
    asset.edits.clear();
    asset.shaping.roughness = preset.roughness;
    asset.cutAtImpact = preset.cutAtImpact;
}

}  // namespace

Addition addMaterial(const Project& project, const MaterialPreset& preset) {
    Addition addition{{.text = MaterialEditsTexts::tr("Add Material")}};
    addition.id = findOrAddMaterial(project, preset, addition.edit);
    return addition;
}

Edit applyPreset(const Project& project, Id asset, const MaterialPreset& preset, const PresetOptions& options) {
    Edit edit{.text = MaterialEditsTexts::tr("Apply Material")};
    Asset changed = *findAsset(project, asset);
    changed.material = findOrAddMaterial(project, preset, edit);
    if (options.appliesPattern) applyPattern(project, preset, changed, edit);
    if (options.derivesThreshold && preset.tensileStrength && !changed.contactTime) deriveThreshold(changed);
    edit.replacements.push_back(Replacement<Asset>{asset, std::move(changed)});
    return edit;
}

MaterialPreset presetFrom(const Project& project, Id material, Id activeAsset) {
    const auto hasMaterial = [&](const Asset& asset) { return asset.material == material; };
    const Asset* asset = findAsset(project, activeAsset);
    if (asset == nullptr || !hasMaterial(*asset)) {
        const auto first = std::ranges::find_if(project.assets, hasMaterial);
        asset = first != project.assets.end() ? &*first : nullptr;
    }
    return presetOf(*findMaterial(project, material), asset);
}

}  // namespace rubble
