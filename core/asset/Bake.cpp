#include "core/asset/Bake.h"

#include "core/asset/Breaking.h"
#include "core/base/Parallel.h"
#include "core/geometry/ConvexParts.h"

#include <algorithm>

namespace rubble {
namespace {

/// The prism as convex hulls about its centre of mass.
Result<std::vector<Polytope>> hullsOfWhole(const Prism& prism, const MassProperties& mass) {
    const Result<IndexLoops> parts = convexParts(prism.outline);
    if (!parts) return parts.error();
    Ring corners = prism.outline.outer;
    for (const Ring& hole : prism.outline.holes) corners.insert(corners.end(), hole.begin(), hole.end());
    std::vector<Polytope> hulls;
    for (const std::vector<std::uint32_t>& part : *parts) {
        Ring ring;
        for (const std::uint32_t corner : part) ring.push_back(corners[corner] - Vec2{mass.centre});
        hulls.push_back(extruded(ring, -prism.depth / 2.0, prism.depth / 2.0));
    }
    return hulls;
}

/// Appends what became of a fragment (kNone: of the whole), and names and places it.
void append(Breaking&& breaking, std::uint32_t parent, Bake& bake) {
    const std::string parentId = parent == kNone ? std::to_string(bake.asset) : bake.fragments[parent].id;
    std::vector<std::string> ids = fragmentIds(parentId, breaking);
    const Vec3 origin = parent == kNone ? Vec3{0.0, 0.0, 0.0} : bake.fragments[parent].solid.offset;
    const std::uint32_t level = parent == kNone ? 0 : bake.fragments[parent].level + 1;
    if (parent != kNone) {
        bake.fragments[parent].firstChild = static_cast<std::uint32_t>(bake.fragments.size());
        bake.fragments[parent].childCount = static_cast<std::uint32_t>(ids.size());
    }
    for (std::size_t k = 0; k < ids.size(); ++k) {
        BakedFragment& fragment = bake.fragments.emplace_back();
        fragment.id = std::move(ids[k]);
        fragment.parent = parent;
        fragment.level = level;
        fragment.solid = std::move(breaking.fragments.fragments[k]);
        fragment.solid.offset += origin;
    }
    for (std::vector<Report>* reports : {&breaking.seeds.reports, &breaking.fragments.reports}) {
        for (Report& report : *reports) {
            if (parent != kNone) report.message = "Fragment " + parentId + ": " + report.message;
            bake.reports.push_back(std::move(report));
        }
    }
}

/// The work below one level: which fragments break, and what became of each.
struct LevelWork {
    std::vector<std::uint32_t> parents;
    std::vector<std::optional<Result<Breaking>>> breakings;  // one a parent
};

LevelWork brokenLevel(const Level& level, std::size_t first, const Bake& bake, const TaskContext& task) {
    LevelWork work;
    for (std::size_t k = first; k < bake.fragments.size(); ++k) {
        if (bake.fragments[k].solid.mass.volume < level.minimumVolume) continue;
        work.parents.push_back(static_cast<std::uint32_t>(k));
    }
    work.breakings.resize(work.parents.size());
    TaskContext quiet;  // progress is told by the work's own thread, level by level
    quiet.cancel = task.cancel;
    forEachIndex(work.parents.size(), task.threads, [&](std::size_t k) {
        const BakedFragment& parent = bake.fragments[work.parents[k]];
        work.breakings[k] =
            brokenBy(patternFor(parent.id, level.pattern), {parent.solid.outline, parent.solid.depth}, quiet);
    });
    return work;
}

/// Breaks the fragments from `first` on by a level; a fragment that would give one piece stays whole.
Status appendLevel(const Level& level, std::size_t first, const TaskContext& task, Bake& bake) {
    LevelWork work = brokenLevel(level, first, bake, task);
    for (std::size_t k = 0; k < work.parents.size(); ++k) {
        Result<Breaking>& breaking = *work.breakings[k];
        const std::uint32_t parent = work.parents[k];
        if (!breaking) {
            if (breaking.error().code == ErrorCode::Cancelled) return breaking.error();
            return Error{breaking.error().code,
                         "Fragment " + bake.fragments[parent].id + ": " + breaking.error().message};
        }
        if (breaking->fragments.fragments.size() > 1) append(std::move(*breaking), parent, bake);
    }
    return success();
}

}  // namespace

Result<Bake> bake(const Asset& asset, const TaskContext& task) {
    Result<Breaking> first =
        brokenBy(asset.pattern, asset.prism, task.stage(0.0, 1.0 / static_cast<double>(asset.levels.size() + 1)));
    if (!first) return ofAsset(asset, first.error());
    Bake result;
    result.asset = asset.id;
    result.input = bakeInputHash(asset);
    result.whole = massOfPrism(first->prism.outline, first->prism.depth);
    Result<std::vector<Polytope>> hulls = hullsOfWhole(first->prism, result.whole);
    if (!hulls) return ofAsset(asset, hulls.error());
    result.wholeHulls = std::move(*hulls);
    result.fragments.reserve(first->fragments.fragments.size());
    append(std::move(*first), kNone, result);
    result.seeds = std::move(first->seeds);
    result.partition = std::move(first->partition);

    std::size_t begin = 0;
    for (std::size_t level = 0; level < asset.levels.size(); ++level) {
        task.report(static_cast<double>(level + 1) / static_cast<double>(asset.levels.size() + 1));
        const std::size_t end = result.fragments.size();
        const Status appended = appendLevel(asset.levels[level], begin, task, result);
        if (!appended) return ofAsset(asset, appended.error());
        begin = end;
    }
    task.report(1.0);
    return result;
}

}  // namespace rubble
