#include "core/asset/bake/Bake.h"

#include "core/asset/bake/BakeEstimate.h"
#include "core/asset/bake/BakeHash.h"
#include "core/asset/bake/FractureResult.h"
#include "core/asset/bake/PrismHulls.h"
#include "core/asset/project/FragmentLevels.h"
#include "core/asset/project/Ranges.h"
#include "core/base/MessageText.h"
#include "core/base/Parallel.h"
#include "core/fracture/partition/CappedDiagnostics.h"
#include "core/fracture/pattern/PieceEstimate.h"

#include <algorithm>
#include <set>

namespace rubble {
namespace {

/// A diagnostic of the fracture of a fragment (kNone: of the whole) with its place in the bake.
Diagnostic located(Diagnostic one, const Seeds& seeds, std::uint32_t parent, const Bake& bake) {
    DiagnosticPlace& place = one.place;
    place.asset = bake.asset;
    if (parent != kNone) {
        const BakedFragment whole = bake.fragment(parent);
        const Vec2 offset{whole.solid.offset()};
        const std::string id = bake.fragmentId(parent);
        place.level = whole.level + 1;
        place.fragment = parent;
        place.path = pathOfId(id);
        place.point = {offset.x, offset.y};
        one.message = "Fragment " + id + ": " + one.message;
    } else if (place.index == kNone && place.seed < seeds.ids.size()) {
        const Vec2 position = seeds.positions[place.seed];
        place.layer = seeds.ids[place.seed].layer;
        place.index = seeds.ids[place.seed].index;
        place.point = {position.x, position.y};
    }
    return one;
}

/// Appends the fracture of a fragment (kNone: of the whole).
void append(FractureResult&& fracture, std::uint32_t parent, Bake& bake, CappedDiagnostics& diagnostics) {
    for (std::vector<Diagnostic>* list : {&fracture.seeds.diagnostics, &fracture.fragments.diagnostics}) {
        for (Diagnostic& one : *list) {
            const DiagnosticCode code = one.code;
            diagnostics.add(code, [&] { return located(std::move(one), fracture.seeds, parent, bake); });
        }
        *list = {};
    }
    std::uint32_t level = 0;
    if (parent != kNone) {
        const BakedFragment whole = bake.fragment(parent);
        level = whole.level + 1;
        fracture.fragments.origin = whole.solid.offset();
    }
    bake.fractures.push_back(
        {parent, level, bake.fragmentCount(), std::move(fracture.seeds), std::move(fracture.fragments)});
}

/// The fragments of one level that are fractured, their settings and their results.
struct LevelWork {
    std::vector<std::uint32_t> parents;
    std::vector<const Level*> levels;  // this and the next: one per parent
    std::vector<std::optional<Result<FractureResult>>> fractures;
};

/// The fragments of a level to fracture, from `first` on.
LevelWork levelWork(const Asset& asset, std::uint32_t level, std::uint32_t first, const Bake& bake) {
    LevelWork work;
    for (std::uint32_t k = first; k < bake.fragmentCount(); ++k) {
        const FragmentPath path = asset.fragmentLevels.empty() ? FragmentPath() : bake.fragmentPath(k);
        const Level* by = levelFor(asset, path, level);
        if (!by || bake.fragment(k).solid.volume() < by->minimumVolume) continue;
        work.parents.push_back(k);
        work.levels.push_back(by);
    }
    return work;
}

/// Refuses a level that makes the bake too large.
Status checkSize(const Asset& asset, const LevelWork& work, const Bake& bake) {
    BakeEstimate estimate = estimateOf(bake);
    for (std::size_t k = 0; k < work.parents.size(); ++k) {
        const Fragment solid = bake.fragment(work.parents[k]).solid;
        const std::optional<ExtrudedFragment> extruded = solid.extruded();
        const double filled = extruded ? solid.volume() / extruded->depth() : solid.volume();
        const double pieces = estimatedPieces(work.levels[k]->pattern, filled);
        estimate.fragments += pieces;
        estimate.largest = std::max(estimate.largest, pieces);
        estimate.fractures += 1.0;
        if (extruded) continue;
        estimate.ofMeshes += pieces;
        if (asset.shaping.gap > 0.0) estimate.shrunk += pieces;
        estimate.triangles += static_cast<double>(solid.all().solid()->triangleCount(solid.index()));
    }
    if (const std::optional<std::string> fault = sizeFault(estimate)) return Error{ErrorCode::Limit, *fault};
    return success();
}

void fracture(const Asset& asset, const Bake& bake, const BakeSettings& settings, const TaskContext& task,
              LevelWork& work) {
    work.fractures.resize(work.parents.size());
    TaskContext quiet;  // the calling thread reports progress, level by level
    quiet.cancel = task.cancel;
    forEachIndex(work.parents.size(), task.threads, [&](std::size_t k) {
        const std::uint32_t parent = work.parents[k];
        const Fragment solid = bake.fragment(parent).solid;
        Recipe recipe = recipeOf(asset, bake.fragmentId(parent), *work.levels[k], solid.offset());
        recipe.hulls = settings.hulls;
        work.fractures[k] = fractureResult(recipe, solid, quiet);
    });
}

/// Fractures the fragments of a level, from `first` on. One that would give a single piece stays as it is.
Status appendLevel(const Asset& asset, std::uint32_t level, std::uint32_t first, const BakeSettings& settings,
                   const TaskContext& task, Bake& bake, CappedDiagnostics& diagnostics) {
    LevelWork work = levelWork(asset, level, first, bake);
    if (const Status checked = checkSize(asset, work, bake); !checked) return checked;
    fracture(asset, bake, settings, task, work);
    bake.fractures.reserve(bake.fractures.size() + work.parents.size());
    for (std::size_t k = 0; k < work.parents.size(); ++k) {
        Result<FractureResult>& fracture = *work.fractures[k];
        const std::uint32_t parent = work.parents[k];
        if (!fracture) {
            if (fracture.error().code == ErrorCode::Cancelled) return fracture.error();
            return Error{fracture.error().code,
                         "Fragment " + bake.fragmentId(parent) + ": " + fracture.error().message};
        }
        if (fracture->fragments.count() > 1) append(std::move(*fracture), parent, bake, diagnostics);
    }
    return success();
}

/// The largest number of levels below the first that an asset can have.
std::size_t maxLevels(const Asset& asset) {
    std::size_t deepest = asset.levels.size();
    for (const FragmentLevel& leaf : asset.fragmentLevels) {
        if (leaf.level) deepest = std::max(deepest, std::size_t{levelOf(leaf.fragment)} + 1);
    }
    return deepest;
}

/// Reports settings and edits of fragments that do not exist.
void reportLost(const Asset& asset, Bake& bake) {
    if (asset.fragmentLevels.empty() && asset.edits.empty()) return;
    std::set<FragmentPath> fragments, broken;
    for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) fragments.insert(bake.fragmentPath(k));
    for (const BakedFracture& fracture : bake.fractures) {
        broken.insert(fracture.parent == kNone ? FragmentPath() : bake.fragmentPath(fracture.parent));
    }
    const auto report = [&](const FragmentPath& path, const std::string& message) {
        bake.diagnostics.push_back(diagnostic(DiagnosticCode::LostPiece, {.asset = bake.asset, .path = path}, message));
    };
    for (const FragmentLevel& leaf : asset.fragmentLevels) {
        if (fragments.contains(leaf.fragment)) continue;
        report(leaf.fragment, "Fragment " + leaf.fragment + " has its own pattern, but does not exist.");
    }
    for (const FragmentEdit& edit : asset.edits) {
        const FragmentPath parent = parentOf(edit);
        if (!broken.contains(parent))
            report(parent, "Fragment " + parent + " is not fractured; none of its fragments is merged or split.");
    }
}

/// Adds the mass and the hulls of the whole.
Status addWhole(const Asset& asset, const Prism& prism, const BakeSettings& settings, const TaskContext& task,
                Bake& bake) {
    if (settings.whole) {
        bake.whole = settings.whole->whole;
        bake.wholeHulls = settings.whole->wholeHulls;
        return success();
    }
    const ClosedMesh* mesh = asset.mesh();
    bake.whole = mesh ? mesh->mass : massOfPrism(prism.outline, prism.depth);
    Result<std::vector<Polytope>> hulls =
        mesh ? meshHulls(*mesh, bake.whole.centre, task) : prismHulls(prism, Vec2{bake.whole.centre});
    if (!hulls) return hulls.error();
    bake.wholeHulls = std::move(*hulls);
    return success();
}

}  // namespace

std::uint32_t Bake::fragmentCount() const {
    return fractures.empty() ? 0 : fractures.back().first + fractures.back().fragments.count();
}

BakedFragment Bake::fragment(std::uint32_t number) const {
    const BakedFracture& fracture = fractures[fractureContaining(number)];
    BakedFragment fragment{.parent = fracture.parent,
                           .level = fracture.level,
                           .firstSibling = fracture.first,
                           .solid = fracture.fragments[number - fracture.first]};
    if (const BakedFracture* children = fractureOf(number)) {
        fragment.firstChild = children->first;
        fragment.childCount = children->fragments.count();
    }
    return fragment;
}

std::string Bake::fragmentId(std::uint32_t number) const {
    const BakedFracture& fracture = fractures[fractureContaining(number)];
    const std::string parentId = fracture.parent == kNone ? std::to_string(asset) : fragmentId(fracture.parent);
    return rubble::fragmentId(parentId, fracture.seeds, fracture.fragments[number - fracture.first]);
}

std::uint32_t Bake::fractureContaining(std::uint32_t number) const {
    const auto next = std::ranges::upper_bound(fractures, number, {}, &BakedFracture::first);
    return static_cast<std::uint32_t>(next - fractures.begin()) - 1;
}

const BakedFracture* Bake::fractureOf(std::uint32_t parent) const {
    if (parent == kNone) return fractures.empty() ? nullptr : &fractures.front();
    const auto below = std::span(fractures).subspan(1);
    const auto found = std::ranges::lower_bound(below, parent, {}, &BakedFracture::parent);
    return found != below.end() && found->parent == parent ? &*found : nullptr;
}

Result<Bake> bake(const Asset& asset, const TaskContext& task, const BakeSettings& settings) {
    if (const std::optional<std::string> fault = shapeRangeFault("Asset " + quotedName(asset.name), asset)) {
        return Error{ErrorCode::BadInput, *fault};
    }
    if (const std::optional<std::string> fault = sizeFault(estimateOf(asset))) {
        return ofAsset(asset, {ErrorCode::Limit, *fault});
    }
    const std::size_t levels = maxLevels(asset);
    Recipe recipe = recipeOf(asset);
    recipe.hulls = settings.hulls;
    Result<FractureResult> first =
        fractureResult(recipe, asset, task.stage(0.0, 1.0 / static_cast<double>(levels + 1)));
    if (!first) return ofAsset(asset, first.error());
    Bake result;
    result.asset = asset.id;
    result.input = bakeInputHash(asset);
    if (const Status made = addWhole(asset, first->prism, settings, task, result); !made)
        return ofAsset(asset, made.error());
    CappedDiagnostics diagnostics;
    append(std::move(*first), kNone, result, diagnostics);

    std::uint32_t begin = 0;
    for (std::uint32_t level = 0; level < levels; ++level) {
        task.report(static_cast<double>(level + 1) / static_cast<double>(levels + 1));
        const std::uint32_t end = result.fragmentCount();
        const Status appended = appendLevel(asset, level, begin, settings, task, result, diagnostics);
        if (!appended) return ofAsset(asset, appended.error());
        begin = end;
    }
    result.diagnostics = std::move(diagnostics).list({.asset = asset.id});
    reportLost(asset, result);
    task.report(1.0);
    return result;
}

}  // namespace rubble
