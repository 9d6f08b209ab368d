#include "core/asset/Bake.h"

#include "core/asset/Breaking.h"
#include "core/asset/PrismHulls.h"
#include "core/base/Parallel.h"

#include <algorithm>

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

/// The work below one level: which fragments break, and what became of each.
struct LevelWork {
    std::vector<std::uint32_t> parents;
    std::vector<std::optional<Result<Breaking>>> breakings;  // one a parent
};

LevelWork brokenLevel(const Level& level, std::uint32_t first, const Bake& bake, const TaskContext& task) {
    LevelWork work;
    for (std::uint32_t k = first; k < bake.fragmentCount(); ++k) {
        if (bake.fragment(k).solid.volume() >= level.minimumVolume) work.parents.push_back(k);
    }
    work.breakings.resize(work.parents.size());
    TaskContext quiet;  // progress is told by the work's own thread, level by level
    quiet.cancel = task.cancel;
    forEachIndex(work.parents.size(), task.threads, [&](std::size_t k) {
        const std::uint32_t parent = work.parents[k];
        const Fragment solid = bake.fragment(parent).solid;
        work.breakings[k] =
            brokenBy(patternFor(bake.fragmentId(parent), level.pattern), {solid.outline(), solid.depth()}, quiet);
    });
    return work;
}

/// Breaks the fragments from `first` on by a level; a fragment that would give one piece stays whole.
Status appendLevel(const Level& level, std::uint32_t first, const TaskContext& task, Bake& bake) {
    LevelWork work = brokenLevel(level, first, bake, task);
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

}  // namespace

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
    Result<Breaking> first =
        brokenBy(asset.pattern, asset.prism, task.stage(0.0, 1.0 / static_cast<double>(asset.levels.size() + 1)));
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
    for (std::size_t level = 0; level < asset.levels.size(); ++level) {
        task.report(static_cast<double>(level + 1) / static_cast<double>(asset.levels.size() + 1));
        const std::uint32_t end = result.fragmentCount();
        const Status appended = appendLevel(asset.levels[level], begin, task, result);
        if (!appended) return ofAsset(asset, appended.error());
        begin = end;
    }
    task.report(1.0);
    return result;
}

}  // namespace rubble
