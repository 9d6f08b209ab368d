#include "viewport/scene/AssetModel.h"

#include "core/asset/PieceColours.h"

namespace rubble {
namespace {

/// Whether a fragment is drawn, and not its parent or its children in its place.
bool isShown(const BakedFragment& fragment, std::uint32_t level) {
    return fragment.level == level || (fragment.level < level && fragment.childCount == 0);
}

void addFragments(AssetModel& model, SceneGeometry& geometry, SceneGeometry* hulls) {
    for (std::uint32_t k = 0; k < model.bake->fragmentCount(); ++k) {
        const BakedFragment fragment = model.bake->fragment(k);
        if (!isShown(fragment, model.level)) continue;
        const Fragment& solid = fragment.solid;
        model.pieces.push_back({k, solid.offset(), solid.volume(), pieceColour(model.bake->fragmentId(k))});
        addPiece(geometry, fragmentMesh(fragment, model.asset));
        if (hulls != nullptr) addPiece(*hulls, solid.hulls());
    }
}

/// The whole, by the bake of an asset that nothing breaks.
void addWhole(AssetModel& model, SceneGeometry& geometry, SceneGeometry* hulls) {
    Asset unbroken = model.asset;
    unbroken.pattern.layers.clear();
    unbroken.levels.clear();
    const Result<Bake> whole = bake(unbroken);
    if (!whole) return;
    model.pieces.push_back({kNone, whole->whole.centre, whole->whole.volume, pieceColour(std::to_string(unbroken.id))});
    addPiece(geometry, wholeMesh(*whole, unbroken));
    if (hulls != nullptr) addPiece(*hulls, whole->wholeHulls);
}

}  // namespace

AssetModel modelOf(const Asset& asset, std::shared_ptr<const Bake> bake, const SceneOptions& options) {
    AssetModel model{.asset = asset, .bake = std::move(bake), .level = options.level};
    const auto geometry = std::make_shared<SceneGeometry>();
    const auto hulls = options.hasHulls ? std::make_shared<SceneGeometry>() : nullptr;
    model.bake ? addFragments(model, *geometry, hulls.get()) : addWhole(model, *geometry, hulls.get());
    model.geometry = geometry;
    model.hulls = hulls;
    return model;
}

}  // namespace rubble
