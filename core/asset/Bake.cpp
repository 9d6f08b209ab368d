#include "core/asset/Bake.h"

#include "core/asset/Breaking.h"
#include "core/asset/PrismHulls.h"
#include "core/base/Parallel.h"

#include <algorithm>
#include <set>

namespace rubble {
namespace {

/// Appends what became of a fragment (kNone: of the whole), and places it.
void append(Breaking&& breaking, std::uint32_t parent, Bake& bake) {
    for (std::vector<Report>* reports : {&breaking.seeds.reports, &breaking.fragments.reports}) {
        for (Report& report : *reports) {
            if (parent != kNone) report.message = "Fragment " + bake.fragmentId(parent) + ": " + report.message;
            bake.reports.push_back(std::move(report));
        }
        reports->clear();
    }
    BakedBreaking baked{parent, 0, bake.fragmentCount(), std::move(breaking.seeds), std::move(breaking.fragments)};
    if (parent != kNone) {
        const BakedFragment whole = bake.fragment(parent);
        baked.level = whole.level + 1;
        baked.fragments.origin = whole.solid.offset();
    }
    bake.breakings.push_back(std::move(baked));
}

/// The breaking that a fragment comes from.
const BakedBreaking& breakingWith(const Bake& bake, std::uint32_t number) {
    return *std::prev(std::ranges::upper_bound(bake.breakings, number, {}, &BakedBreaking::first));
}

/// The work below one level: which fragments break, by what, and what became of each.
struct LevelWork {
    std::vector<std::uint32_t> parents;
    std::vector<const Level*> levels;  // this and the next: one a parent
    std::vector<std::optional<Result<Breaking>>> breakings;
};

LevelWork brokenLevel(const Asset& asset, std::uint32_t level, std::uint32_t first, const Bake& bake,
                      const TaskContext& task) {
    LevelWork work;
    for (std::uint32_t k = first; k < bake.fragmentCount(); ++k) {
        const FragmentPath path = asset.leaves.empty() ? FragmentPath() : pathOfId(bake.fragmentId(k));
        const Level* by = levelFor(asset, path, level);
        if (!by || bake.fragment(k).solid.volume() < by->minimumVolume) continue;
        work.parents.push_back(k);
        work.levels.push_back(by);
    }
    work.breakings.resize(work.parents.size());
    TaskContext quiet;  // progress is told by the work's own thread, level by level
    quiet.cancel = task.cancel;
    forEachIndex(work.parents.size(), task.threads, [&](std::size_t k) {
        const std::uint32_t parent = work.parents[k];
        const Fragment solid = bake.fragment(parent).solid;
        const Recipe recipe = recipeOf(asset, bake.fragmentId(parent), *work.levels[k], Vec2{solid.offset()});
        work.breakings[k] = brokenBy(recipe, {solid.outline(), solid.depth()}, quiet);
    });
    return work;
}

/// Breaks the fragments of a level, from `first` on; a fragment that would give one piece stays whole.
Status appendLevel(const Asset& asset, std::uint32_t level, std::uint32_t first, const TaskContext& task, Bake& bake) {
    LevelWork work = brokenLevel(asset, level, first, bake, task);
    bake.breakings.reserve(bake.breakings.size() + work.parents.size());
    for (std::size_t k = 0; k < work.parents.size(); ++k) {
        Result<Breaking>& breaking = *work.breakings[k];
        const std::uint32_t parent = work.parents[k];
        if (!breaking) {
            if (breaking.error().code == ErrorCode::Cancelled) return breaking.error();
            return Error{breaking.error().code,
                         "Fragment " + bake.fragmentId(parent) + ": " + breaking.error().message};
        }
        if (breaking->fragments.count() > 1) append(std::move(*breaking), parent, bake);
    }
    return success();
}

/// How many levels an asset may have below the first.
std::size_t deepestLevel(const Asset& asset) {
    std::size_t deepest = asset.levels.size();
    for (const FragmentLevel& leaf : asset.leaves) {
        if (leaf.level) deepest = std::max(deepest, std::size_t{levelOf(leaf.fragment)} + 1);
    }
    return deepest;
}

/// Says of what is to be done with single fragments that they are not there.
void reportLost(const Asset& asset, Bake& bake) {
    if (asset.leaves.empty() && asset.edits.empty()) return;
    std::set<FragmentPath> fragments, broken;
    for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) fragments.insert(pathOfId(bake.fragmentId(k)));
    for (const BakedBreaking& breaking : bake.breakings) {
        broken.insert(breaking.parent == kNone ? FragmentPath() : pathOfId(bake.fragmentId(breaking.parent)));
    }
    const auto report = [&](const std::string& message) {
        bake.reports.push_back({ReportCode::LostPiece, kNone, kNone, 0.0, message});
    };
    for (const FragmentLevel& leaf : asset.leaves) {
        if (fragments.contains(leaf.fragment)) continue;
        report("The piece " + leaf.fragment + ", which is to be broken in its own way, is not there.");
    }
    for (const FragmentEdit& edit : asset.edits) {
        const FragmentPath place = placeOf(edit);
        if (!broken.contains(place))
            report("The piece " + place + " is not broken; none of its pieces is merged or split.");
    }
}

}  // namespace

const Level* levelFor(const Asset& asset, const FragmentPath& fragment, std::uint32_t level) {
    const auto leaf = std::ranges::lower_bound(asset.leaves, fragment, {}, &FragmentLevel::fragment);
    if (leaf != asset.leaves.end() && leaf->fragment == fragment) return leaf->level ? &*leaf->level : nullptr;
    return level < asset.levels.size() ? &asset.levels[level] : nullptr;
}

std::uint32_t Bake::fragmentCount() const {
    return breakings.empty() ? 0 : breakings.back().first + breakings.back().fragments.count();
}

BakedFragment Bake::fragment(std::uint32_t number) const {
    const BakedBreaking& breaking = breakingWith(*this, number);
    BakedFragment fragment{.parent = breaking.parent,
                           .level = breaking.level,
                           .firstSibling = breaking.first,
                           .solid = breaking.fragments[number - breaking.first]};
    if (const BakedBreaking* pieces = breakingOf(number)) {
        fragment.firstChild = pieces->first;
        fragment.childCount = pieces->fragments.count();
    }
    return fragment;
}

std::string Bake::fragmentId(std::uint32_t number) const {
    const BakedBreaking& breaking = breakingWith(*this, number);
    const std::string parentId = breaking.parent == kNone ? std::to_string(asset) : fragmentId(breaking.parent);
    return rubble::fragmentId(parentId, breaking.seeds, breaking.fragments[number - breaking.first]);
}

const BakedBreaking* Bake::breakingOf(std::uint32_t parent) const {
    if (parent == kNone) return breakings.empty() ? nullptr : &breakings.front();
    const auto below = std::span(breakings).subspan(1);
    const auto found = std::ranges::lower_bound(below, parent, {}, &BakedBreaking::parent);
    return found != below.end() && found->parent == parent ? &*found : nullptr;
}

Result<Bake> bake(const Asset& asset, const TaskContext& task) {
    const std::size_t levels = deepestLevel(asset);
    Result<Breaking> first =
        brokenBy(recipeOf(asset), asset.prism, task.stage(0.0, 1.0 / static_cast<double>(levels + 1)));
    if (!first) return ofAsset(asset, first.error());
    Bake result;
    result.asset = asset.id;
    result.input = bakeInputHash(asset);
    result.whole = massOfPrism(first->prism.outline, first->prism.depth);
    Result<std::vector<Polytope>> hulls = prismHulls(first->prism, Vec2{result.whole.centre});
    if (!hulls) return ofAsset(asset, hulls.error());
    result.wholeHulls = std::move(*hulls);
    append(std::move(*first), kNone, result);

    std::uint32_t begin = 0;
    for (std::uint32_t level = 0; level < levels; ++level) {
        task.report(static_cast<double>(level + 1) / static_cast<double>(levels + 1));
        const std::uint32_t end = result.fragmentCount();
        const Status appended = appendLevel(asset, level, begin, task, result);
        if (!appended) return ofAsset(asset, appended.error());
        begin = end;
    }
    reportLost(asset, result);
    task.report(1.0);
    return result;
}

}  // namespace rubble
