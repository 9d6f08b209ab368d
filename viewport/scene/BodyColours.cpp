#include "viewport/scene/BodyColours.h"

#include "core/asset/PieceColours.h"

#include <algorithm>

namespace rubble {
namespace {

/// A model may be older than its asset's choice of material.
const Material* materialOf(const AssetModel& model, const Project& project) {
    const Asset* asset = findAsset(project, model.asset.id);
    return findMaterial(project, asset != nullptr ? asset->material : model.asset.material);
}

/// The one whose inside its cuts lay open; null where there is none of its own.
const Material* insideOf(const AssetModel& model, const Project& project) {
    const Asset* asset = findAsset(project, model.asset.id);
    return findMaterial(project, asset != nullptr ? asset->insideMaterial : model.asset.insideMaterial);
}

/// The volumes of a scene's smallest and largest pieces.
struct VolumeRange {
    double least = 1e308, most = 0.0;  // m^3
    double share(double volume) const { return most > least ? (volume - least) / (most - least) : 0.5; }
};

VolumeRange volumesOf(const RenderScene& scene, std::span<const AssetModel* const> models) {
    VolumeRange range;
    for (std::size_t k = 0; k < models.size(); ++k) {
        if (scene.batches[k].firstBodies.empty()) continue;
        for (const ModelPiece& piece : models[k]->pieces) {
            range.least = std::min(range.least, piece.volume);
            range.most = std::max(range.most, piece.volume);
        }
    }
    return range;
}

}  // namespace

void paintBodies(RenderScene& scene, std::span<const AssetModel* const> models, const Project& project,
                 SceneColouring colouring) {
    const VolumeRange volumes = volumesOf(scene, models);
    for (std::size_t k = 0; k < models.size(); ++k) {
        const Material* material = colouring == SceneColouring::Material ? materialOf(*models[k], project) : nullptr;
        const Material* open = material != nullptr ? insideOf(*models[k], project) : nullptr;
        for (std::uint32_t piece = 0; piece < models[k]->pieces.size(); ++piece) {
            const ModelPiece& shown = models[k]->pieces[piece];
            Colour outside = material != nullptr ? material->outside : shown.colour;
            if (colouring == SceneColouring::Volume) outside = rampColour(volumes.share(shown.volume));
            const Colour inside = material != nullptr ? (open != nullptr ? open : material)->inside : insideOf(outside);
            for (const std::uint32_t first : scene.batches[k].firstBodies) {
                scene.looks[first + piece].outside = packed(outside);
                scene.looks[first + piece].inside = packed(inside);
            }
        }
    }
}

}  // namespace rubble
