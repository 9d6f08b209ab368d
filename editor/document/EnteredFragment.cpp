#include "editor/document/EnteredFragment.h"

#include "core/asset/bake/FragmentLookup.h"
#include "core/asset/project/FragmentLevels.h"

namespace rubble {

namespace {

bool isFractured(const Asset& asset, const Bake* bake, const FragmentPath& fragment) {
    const Level* level = levelFor(asset, fragment, levelOf(fragment));
    if (!level || !bake) return level != nullptr;
    const std::optional<std::uint32_t> number = fragmentAt(*bake, fragment);
    return number && bake->fragment(*number).solid.volume() >= level->minimumVolume;
}

std::shared_ptr<const Bake> bakeOf(const Bakes& bakes, Id asset) {
    const std::shared_ptr<const BakedAsset> baked = bakes.find(asset);
    return baked ? baked->bake : nullptr;
}

}  // namespace

std::optional<FragmentSolid> fragmentSolid(const Bakes& bakes, Id asset, const FragmentPath& fragment) {
    if (const std::shared_ptr<const Bake> bake = bakeOf(bakes, asset)) {
        const std::optional<std::uint32_t> number = fragmentAt(*bake, fragment);
        if (!number || *number == kNone) return std::nullopt;
        const Fragment solid = bake->fragment(*number).solid;
        const std::optional<ExtrudedFragment> extruded = solid.extruded();
        if (!extruded) return std::nullopt;
        return FragmentSolid{{extruded->outline(), extruded->depth()}, Vec2{solid.offset()}};
    }
    const std::shared_ptr<const BakedPattern> before = bakes.findPattern(asset, fragment);
    if (!before) return std::nullopt;
    return FragmentSolid{before->asset->prism(), before->offset};
}

Asset fragmentAsAsset(Asset asset, const FragmentPath& fragment, Prism prism) {
    const Level* level = levelFor(asset, fragment, levelOf(fragment));
    asset.pattern = level ? Pattern(level->pattern) : Pattern();
    asset.shape = std::move(prism);
    return asset;
}

FragmentPath nearestFractured(const Asset& asset, const Bake* bake, const FragmentPath& fragment) {
    FragmentPath nearest;
    while (nearest != fragment) {
        FragmentPath next = childOnPath(nearest, fragment);
        if (!isFractured(asset, bake, next)) break;
        nearest = std::move(next);
    }
    return nearest;
}

void enterFragment(Selection& selection, const FragmentPath& fragment) {
    selection.setEnteredFragment(fragment);
    selection.setFragments({});
}

void exitToFragment(Selection& selection, const FragmentPath& ancestor) {
    if (selection.enteredFragment() == ancestor) return;
    const FragmentPath left = childOnPath(ancestor, selection.enteredFragment());
    const std::optional<PieceName> name = pieceNameOf(left);
    selection.setEnteredFragment(ancestor);
    if (!name) return selection.setFragments({});
    FragmentSelection fragments{.seeds = {name->seed}, .parent = ancestor};
    // The seed may have other pieces.
    const bool isOnlyPiece = name->partOfCell == kNone && name->cells.empty();
    if (!isOnlyPiece) fragments.ids = {std::to_string(selection.asset()) + "/" + left};
    selection.setFragments(std::move(fragments));
}

void exitRemovedFragments(Selection& selection, const Project& project, const Bakes& bakes) {
    const Asset* asset = findAsset(project, selection.asset());
    if (!asset || selection.enteredFragment().empty()) return;
    const FragmentPath nearest = nearestFractured(*asset, bakeOf(bakes, asset->id).get(), selection.enteredFragment());
    if (nearest == selection.enteredFragment()) return;
    selection.setEnteredFragment(nearest);
    selection.setFragments({});
}

}  // namespace rubble
