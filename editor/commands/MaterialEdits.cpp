#include "editor/commands/MaterialEdits.h"

#include "core/asset/Names.h"
#include "core/asset/Threshold.h"

#include <QCoreApplication>

#include <algorithm>

namespace rubble {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("MaterialEdits", text); }

/// The id of the material that is the copy of a preset; added where it is not there.
Id materialFrom(const Project& project, const MaterialPreset& preset, Edit& edit) {
    for (const Material& material : project.materials) {
        if (material == materialOf(preset, material.id)) return material.id;
    }
    const Id id = edit.takeId(project);
    Material copy = materialOf(preset, id);
    copy.name = freeName(project.materials, copy.name);
    edit.swaps.push_back(Swap<Material>{id, std::move(copy)});
    return id;
}

void takePattern(const Project& project, const MaterialPreset& preset, Asset& asset, Edit& edit) {
    if (preset.pattern.layers.empty()) return;
    asset.pattern = patternWithin(preset, boundsOf(asset.prism.outline.outer));
    for (PatternLayer& layer : asset.pattern.layers) {
        layer.id = edit.takeId(project);
        layer.randomSeed = layer.id;
    }
    asset.leaves.clear();
    asset.edits.clear();
}

}  // namespace

Addition addMaterial(const Project& project, const MaterialPreset& preset) {
    Addition addition{{.text = tr("Add material")}};
    addition.id = materialFrom(project, preset, addition.edit);
    return addition;
}

Edit makeOf(const Project& project, Id asset, const MaterialPreset& preset, const PresetUse& use) {
    Edit edit{.text = tr("Use material")};
    Asset changed = *findAsset(project, asset);
    changed.material = materialFrom(project, preset, edit);
    if (use.takesPattern) takePattern(project, preset, changed, edit);
    if (use.derivesThreshold && preset.tensileStrength && !changed.contactTime) {
        changed.contactTime = kUsualContactTime;
    }
    edit.swaps.push_back(Swap<Asset>{asset, std::move(changed)});
    return edit;
}

MaterialPreset presetFrom(const Project& project, Id material, Id assetAtHand) {
    const auto isOfIt = [&](const Asset& asset) { return asset.material == material; };
    const Asset* asset = findAsset(project, assetAtHand);
    if (asset == nullptr || !isOfIt(*asset)) {
        const auto first = std::ranges::find_if(project.assets, isOfIt);
        asset = first != project.assets.end() ? &*first : nullptr;
    }
    return presetOf(*findMaterial(project, material), asset != nullptr ? asset->pattern : Pattern{});
}

}  // namespace rubble
