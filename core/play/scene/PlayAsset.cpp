#include "core/play/scene/PlayAsset.h"

#include "core/asset/bake/FractureResult.h"
#include "core/asset/strength/FragmentThresholds.h"
#include "core/play/scene/BodyShape.h"
#include "core/structure/capacity/BondCapacities.h"

#include <set>

namespace rubble {
namespace {

/// The shape of a solid; a simplification is added to the diagnostics.
Result<std::shared_ptr<const Shape>> namedShape(const std::string& name, std::span<const Polytope> hulls,
                                                const MassProperties& mass, const DiagnosticPlace& place,
                                                std::vector<Diagnostic>& diagnostics) {
    Result<BodyShape> made = bodyShape(hulls, mass);
    if (!made) return Error{made.error().code, name + ": " + made.error().message};
    if (made->simplified) {
        diagnostics.push_back(diagnostic(DiagnosticCode::SimplifiedShape, place, name + ": " + *made->simplified));
    }
    return std::move(made->shape);
}

PlayFracture playFracture(const BakedFracture& baked) {
    PlayFracture fracture{.first = baked.first, .count = baked.fragments.count()};
    for (std::uint32_t k = 0; k < fracture.count; ++k) {
        for (const FragmentContact& contact : baked.fragments[k].contacts()) {
            fracture.area += contact.area;
            if (contact.fragment > k)
                fracture.neighbours.push_back({baked.first + k, baked.first + contact.fragment, {}});
        }
    }
    return fracture;
}

/// Computes the contact manifolds of all neighbours.
void findContacts(PlayAsset& ready, PlayFracture& fracture) {
    for (PlayContact& pair : fracture.neighbours) {
        const PlaySolid &first = ready.fragments[pair.first], &second = ready.fragments[pair.second];
        pair.manifolds = cachedManifolds(*first.shape, *second.shape, centreInAsset(second) - centreInAsset(first));
    }
}

Status appendSolids(const Asset& asset, const BakedFracture& baked, const TaskContext& task, PlayAsset& ready) {
    const Bake& bake = *ready.bake;
    for (std::uint32_t k = 0; k < baked.fragments.count(); ++k) {
        if (task.isCancelled()) return TaskContext::cancelled();
        const Fragment solid = baked.fragments[k];
        const MassProperties mass = solid.mass();
        const std::string id = bake.fragmentId(baked.first + k);
        const DiagnosticPlace place{
            .asset = bake.asset, .level = baked.level, .fragment = baked.first + k, .path = pathOfId(id)};
        Result<std::shared_ptr<const Shape>> shape =
            namedShape("Fragment " + id, solid.hulls(), mass, place, ready.diagnostics);
        if (!shape) return shape.error();
        ready.fragments.push_back({.shape = std::move(*shape),
                                   .offset = solid.offset(),
                                   .thresholdScale = thresholdScaleOf(mass.volume / bake.whole.volume),
                                   .threshold = fragmentThreshold(asset, place.path, baked.level)});
    }
    return success();
}

/// Makes the shape of all fragments of a solid together. The asset, which owns their hulls, owns it as well.
void addBondedShape(PlayAsset& ready, std::uint32_t parent) {
    const PlaySolid& whole = ready.solid(parent);
    if (whole.fracture == kNone) return;
    PlayFracture& fracture = ready.fractures[whole.fracture];
    std::vector<CompoundPart> parts;
    fracture.firstHull = {0};
    for (std::uint32_t k = fracture.first; k < fracture.first + fracture.count; ++k) {
        const Shape& shape = *ready.fragments[k].shape;
        parts.push_back({&shape, centreInAsset(ready.fragments[k])});
        fracture.firstHull.push_back(fracture.firstHull.back() + static_cast<std::uint32_t>(shape.hulls.size()));
    }
    MassProperties mass = whole.shape->mass;
    mass.centre += whole.offset;
    Result<std::shared_ptr<const Shape>> shape = compoundShape(parts, mass, nullptr);
    RUBBLE_ASSERT(shape.hasValue());  // the whole can be a body
    fracture.bonded = std::move(*shape);
}

/// Marks the fragments of a bonded asset that never break.
void markNeverBreaking(const Asset& asset, PlayAsset& ready) {
    for (std::uint32_t k = 0; k < ready.bake->fractures.size(); ++k) {
        const std::vector<bool> marks = neverBreaking(asset, *ready.bake, k);
        for (std::uint32_t node = 0; node < marks.size(); ++node) {
            ready.fragments[ready.bake->fractures[k].first + node].neverBreaks = marks[node];
        }
    }
}

/// Reports thresholds of fragments that do not exist, or do not break.
void reportLostThresholds(const Asset& asset, PlayAsset& ready) {
    if (asset.fragmentThresholds.empty()) return;
    std::set<FragmentPath> broken;
    for (const BakedFracture& baked : ready.bake->fractures) {
        if (baked.parent != kNone) broken.insert(ready.bake->fragmentPath(baked.parent));
    }
    for (const FragmentThreshold& own : asset.fragmentThresholds) {
        if (broken.contains(own.fragment)) continue;
        ready.diagnostics.push_back(
            diagnostic(DiagnosticCode::LostPiece, {.asset = asset.id, .path = own.fragment},
                       "Fragment " + own.fragment + " has its own threshold, but does not exist or does not break."));
    }
}

}  // namespace

Vec3 centreInAsset(const PlaySolid& solid) { return solid.offset + solid.shape->mass.centre; }

double thresholdOf(const PlaySolid& solid, double whole) {
    return solid.threshold ? *solid.threshold : whole * solid.thresholdScale;
}

std::vector<Polytope> wholeHullsInPrism(const Bake& bake) {
    std::vector<Polytope> hulls = bake.wholeHulls;
    for (Polytope& hull : hulls) hull = translated(std::move(hull), bake.whole.centre);
    return hulls;
}

const PlayFracture* PlayAsset::fractureOf(std::uint32_t fragment) const {
    const std::uint32_t fracture = solid(fragment).fracture;
    return fracture == kNone ? nullptr : &fractures[fracture];
}

Result<PlayAsset> wholePlayAsset(const Asset& asset, std::shared_ptr<const Bake> bake) {
    PlayAsset ready{.bake = std::move(bake)};
    Result<std::shared_ptr<const Shape>> whole = namedShape("The whole", wholeHullsInPrism(*ready.bake),
                                                            ready.bake->whole, {.asset = asset.id}, ready.diagnostics);
    if (!whole) return ofAsset(asset, whole.error());
    ready.whole.shape = std::move(*whole);
    return ready;
}

Result<std::shared_ptr<const PlayAsset>> playAsset(const Asset& asset, std::shared_ptr<const Bake> bake,
                                                   const TaskContext& task, FindContacts when,
                                                   std::shared_ptr<const Shape> wholeShape) {
    Result<PlayAsset> whole = wholeShape ? PlayAsset{.bake = std::move(bake), .whole = {.shape = std::move(wholeShape)}}
                                         : wholePlayAsset(asset, std::move(bake));
    if (!whole) return whole.error();
    const auto ready = std::make_shared<PlayAsset>(std::move(*whole));
    ready->isBonded = asset.breakAs == BreakAs::Bonded;
    for (const BakedFracture& baked : ready->bake->fractures) {
        if (const Status appended = appendSolids(asset, baked, task, *ready); !appended) {
            return appended.error().code == ErrorCode::Cancelled ? appended.error() : ofAsset(asset, appended.error());
        }
        if (baked.fragments.count() < 2) continue;
        PlaySolid& broken = baked.parent == kNone ? ready->whole : ready->fragments[baked.parent];
        broken.fracture = static_cast<std::uint32_t>(ready->fractures.size());
        ready->fractures.push_back(playFracture(baked));
        if (when == FindContacts::InAdvance && !ready->isBonded) findContacts(*ready, ready->fractures.back());
    }
    if (ready->isBonded) {
        markNeverBreaking(asset, *ready);
        for (const BakedFracture& baked : ready->bake->fractures) addBondedShape(*ready, baked.parent);
    }
    reportLostThresholds(asset, *ready);
    return std::shared_ptr<const PlayAsset>(ready);
}

}  // namespace rubble
