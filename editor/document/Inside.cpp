#include "editor/document/Inside.h"

#include "core/asset/FragmentPlace.h"

namespace rubble {

namespace {

bool isBrokenAgain(const Asset& asset, const Bake* bake, const FragmentPath& fragment) {
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

std::optional<FragmentSolid> solidOf(const Bakes& bakes, Id asset, const FragmentPath& fragment) {
    if (const std::shared_ptr<const Bake> bake = bakeOf(bakes, asset)) {
        const std::optional<std::uint32_t> number = fragmentAt(*bake, fragment);
        if (!number || *number == kNone) return std::nullopt;
        const Fragment solid = bake->fragment(*number).solid;
        return FragmentSolid{{solid.outline(), solid.depth()}, Vec2{solid.offset()}};
    }
    const std::shared_ptr<const BakedPattern> before = bakes.findPattern(asset, fragment);
    if (!before) return std::nullopt;
    return FragmentSolid{before->asset->prism, before->offset};
}

Asset asWhole(Asset asset, const FragmentPath& fragment, Prism prism) {
    const Level* level = levelFor(asset, fragment, levelOf(fragment));
    asset.pattern = level ? Pattern(level->pattern) : Pattern();
    asset.prism = std::move(prism);
    return asset;
}

FragmentPath nearestBroken(const Asset& asset, const Bake* bake, const FragmentPath& fragment) {
    FragmentPath nearest;
    while (nearest != fragment) {
        FragmentPath next = pieceOf(nearest, fragment);
        if (!isBrokenAgain(asset, bake, next)) break;
        nearest = std::move(next);
    }
    return nearest;
}

void goInto(Selection& selection, const FragmentPath& fragment) {
    selection.setInside(fragment);
    selection.setChoice({});
}

void goOut(Selection& selection, const FragmentPath& place) {
    if (selection.inside() == place) return;
    const FragmentPath left = pieceOf(place, selection.inside());
    const std::optional<PieceName> name = pieceNameOf(left);
    selection.setInside(place);
    if (!name) return selection.setChoice({});
    FragmentChoice choice{.seeds = {name->seed}, .inside = place};
    // A seed may have pieces beside this one.
    const bool isAlone = name->partOfCell == kNone && name->cells.empty();
    if (!isAlone) choice.ids = {std::to_string(selection.asset()) + "/" + left};
    selection.setChoice(std::move(choice));
}

void leaveWhatIsGone(Selection& selection, const Project& project, const Bakes& bakes) {
    const Asset* asset = findAsset(project, selection.asset());
    if (!asset || selection.inside().empty()) return;
    const FragmentPath nearest = nearestBroken(*asset, bakeOf(bakes, asset->id).get(), selection.inside());
    if (nearest == selection.inside()) return;
    selection.setInside(nearest);
    selection.setChoice({});
}

}  // namespace rubble
