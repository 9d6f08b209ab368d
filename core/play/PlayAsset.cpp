#include "core/play/PlayAsset.h"

#include "core/asset/Breaking.h"
#include "core/base/Roots.h"
#include "core/play/BodyShape.h"

namespace rubble {
namespace {

/// The shape of a solid; what was made simpler is told with its name.
Result<std::shared_ptr<const Shape>> toldShape(const std::string& name, std::span<const Polytope> hulls,
                                               const MassProperties& mass, std::vector<std::string>& notices) {
    Result<BodyShape> made = bodyShape(hulls, mass);
    if (!made) return Error{made.error().code, name + ": " + made.error().message};
    if (made->simplified) notices.push_back(name + ": " + *made->simplified);
    return std::move(made->shape);
}

PlayBreaking breakingWith(const BakedBreaking& baked) {
    PlayBreaking breaking{.first = baked.first, .count = baked.fragments.count()};
    for (std::uint32_t k = 0; k < breaking.count; ++k) {
        for (const Bond& bond : baked.fragments[k].bonds()) {
            if (bond.fragment > k) breaking.neighbours.push_back({baked.first + k, baked.first + bond.fragment, {}});
        }
    }
    return breaking;
}

/// How neighbours touch.
void findContacts(PlayAsset& ready, PlayBreaking& breaking) {
    const auto centreOf = [](const PlayPiece& piece) { return piece.offset + piece.shape->mass.centre; };
    for (PlayNeighbours& pair : breaking.neighbours) {
        const PlayPiece &first = ready.pieces[pair.first], &second = ready.pieces[pair.second];
        pair.seeds = contactSeeds(*first.shape, *second.shape, centreOf(second) - centreOf(first));
    }
}

Status appendPieces(const BakedBreaking& baked, const TaskContext& task, PlayAsset& ready) {
    const Bake& bake = *ready.bake;
    for (std::uint32_t k = 0; k < baked.fragments.count(); ++k) {
        if (task.isCancelled()) return TaskContext::cancelled();
        const Fragment solid = baked.fragments[k];
        const MassProperties mass = solid.mass();
        Result<std::shared_ptr<const Shape>> shape =
            toldShape("Piece " + bake.fragmentId(baked.first + k), solid.hulls(), mass, ready.notices);
        if (!shape) return shape.error();
        ready.pieces.push_back({.shape = std::move(*shape),
                                .offset = solid.offset(),
                                .toughness = toughnessOf(mass.volume / bake.whole.volume)});
    }
    return success();
}

}  // namespace

double toughnessOf(double share) {
    const double root = cubeRoot(share);
    return root * root;
}

std::vector<Polytope> wholeHullsInPrism(const Bake& bake) {
    std::vector<Polytope> hulls = bake.wholeHulls;
    for (Polytope& hull : hulls) hull = translated(std::move(hull), bake.whole.centre);
    return hulls;
}

const PlayBreaking* PlayAsset::breakingOf(std::uint32_t fragment) const {
    const std::uint32_t breaking = piece(fragment).breaking;
    return breaking == kNone ? nullptr : &breakings[breaking];
}

Result<PlayAsset> playWhole(const Asset& asset, std::shared_ptr<const Bake> bake) {
    PlayAsset ready{.bake = std::move(bake)};
    Result<std::shared_ptr<const Shape>> whole =
        toldShape("The whole", wholeHullsInPrism(*ready.bake), ready.bake->whole, ready.notices);
    if (!whole) return ofAsset(asset, whole.error());
    ready.whole.shape = std::move(*whole);
    return ready;
}

Result<std::shared_ptr<const PlayAsset>> playAsset(const Asset& asset, std::shared_ptr<const Bake> bake,
                                                   const TaskContext& task, FindContacts when) {
    Result<PlayAsset> whole = playWhole(asset, std::move(bake));
    if (!whole) return whole.error();
    const auto ready = std::make_shared<PlayAsset>(std::move(*whole));
    for (const BakedBreaking& baked : ready->bake->breakings) {
        if (const Status appended = appendPieces(baked, task, *ready); !appended) {
            return appended.error().code == ErrorCode::Cancelled ? appended.error() : ofAsset(asset, appended.error());
        }
        if (baked.fragments.count() < 2) continue;
        PlayPiece& broken = baked.parent == kNone ? ready->whole : ready->pieces[baked.parent];
        broken.breaking = static_cast<std::uint32_t>(ready->breakings.size());
        ready->breakings.push_back(breakingWith(baked));
        if (when == FindContacts::Beforehand) findContacts(*ready, ready->breakings.back());
    }
    return std::shared_ptr<const PlayAsset>(ready);
}

}  // namespace rubble
