#include "editor/Baker.h"

#include "core/asset/Breaking.h"

#include <algorithm>

namespace rubble {

namespace {

/// Fills in seeds, triangulation and partition.
Status makePattern(BakedPattern& pattern, const TaskContext& task) {
    Result<PlaneBreaking> cut = cutBy(recipeOf(*pattern.asset), pattern.asset->prism, task);
    if (!cut) return cut.error();
    pattern.seeds = std::move(cut->seeds);
    pattern.triangulation = std::move(cut->delaunay);
    pattern.partition = std::move(cut->partition);
    return success();
}

BakeQueue::Delivery patternOf(Bakes& bakes, std::shared_ptr<const Asset> asset, const TaskContext& task) {
    auto pattern = std::make_shared<BakedPattern>();
    pattern->asset = std::move(asset);
    const Status made = makePattern(*pattern, task);
    if (!made && made.error().code == ErrorCode::Cancelled) return {};
    if (!made) *pattern = {.asset = pattern->asset, .fault = made.error()};
    return [&bakes, pattern] { bakes.setPattern(pattern->asset->id, pattern); };
}

/// What is to be baked of an asset, and what was before.
struct Wish {
    std::shared_ptr<const Asset> asset;
    std::vector<std::uint32_t> variants;  // ascending from 0
    std::vector<std::shared_ptr<const Bake>> known;
};

Wish wishFor(std::shared_ptr<const Asset> asset, const Project& project, const Bakes& bakes) {
    Wish wish{.asset = std::move(asset)};
    for (const auto& [id, variant] : usedVariants(project)) {
        if (id == wish.asset->id) wish.variants.push_back(variant);
    }
    const auto before = bakes.find(wish.asset->id);
    if (!before) return wish;
    if (before->bake) wish.known.push_back(before->bake);
    for (const auto& [variant, bake] : before->variants) wish.known.push_back(bake);
    return wish;
}

/// The bake of a variant: the one before where nothing that it depends on has changed.
Result<std::shared_ptr<const Bake>> bakeOf(const Asset& variant, const Wish& wish, const TaskContext& task) {
    const auto isIt = [input = bakeInputHash(variant)](const auto& bake) { return bake->input == input; };
    if (const auto same = std::ranges::find_if(wish.known, isIt); same != wish.known.end()) return *same;
    Result<Bake> made = bake(variant, task);
    if (!made) return made.error();
    return std::make_shared<const Bake>(std::move(*made));
}

BakeQueue::Delivery fragmentsOf(Bakes& bakes, const Wish& wish, const TaskContext& task) {
    auto baked = std::make_shared<BakedAsset>();
    baked->asset = wish.asset;
    const auto count = static_cast<double>(wish.variants.size());
    for (std::size_t k = 0; k < wish.variants.size() && !baked->fault; ++k) {
        const std::uint32_t variant = wish.variants[k];
        const TaskContext part = task.stage(static_cast<double>(k) / count, static_cast<double>(k + 1) / count);
        Result<std::shared_ptr<const Bake>> made = bakeOf(variantOf(*wish.asset, variant), wish, part);
        if (!made && made.error().code == ErrorCode::Cancelled) return {};
        if (!made) {
            baked->fault = made.error();
        } else {
            (variant == 0 ? baked->bake : baked->variants[variant]) = std::move(*made);
        }
    }
    return [&bakes, baked] { bakes.set(baked->asset->id, baked); };
}

bool isBaked(const Instance& instance, const Bakes& bakes) {
    const auto baked = bakes.find(instance.asset);
    return instance.variant == 0 || (baked && baked->variants.contains(instance.variant));
}

}  // namespace

Baker::Baker(const Document& document, const Selection& selection, Bakes& bakes, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_bakes(bakes),
      m_patterns(document, selection, BakeQueue::Start::AtOnce,
                 [&bakes](auto asset) {
                     return [&bakes, asset](const TaskContext& task) { return patternOf(bakes, asset, task); };
                 }),
      m_fragments(document, selection, BakeQueue::Start::AfterRest, [&bakes, &document](auto asset) {
          return [&bakes, wish = wishFor(std::move(asset), document.project(), bakes)](const TaskContext& task) {
              return fragmentsOf(bakes, wish, task);
          };
      }) {
    connect(&document, &Document::changed, this, &Baker::take);
    connect(&m_fragments, &BakeQueue::progressed, this, &Baker::progressed);
    take({{}, true});
}

void Baker::cancel() {
    m_patterns.cancel();
    m_fragments.cancel();
}

void Baker::take(const Changes& changes) {
    std::set<Id> wanted;
    if (changes.isEverything) {
        m_bakes.clear();
        for (const Asset& asset : m_document.project().assets) wanted.insert(asset.id);
    }
    for (const Change& change : changes.list) {
        if (change.part != Part::Asset) continue;
        if (change.kind == ChangeKind::Removed) {
            m_bakes.remove(change.id);
        } else {
            wanted.insert(change.id);
        }
    }
    if (!wanted.empty()) m_patterns.want(wanted);
    if (changes.touches(Part::Instance)) addUnbaked(wanted);
    if (!wanted.empty()) m_fragments.want(wanted);
}

/// Assets in variants that are used from now on.
void Baker::addUnbaked(std::set<Id>& wanted) const {
    for (const Instance& instance : m_document.project().instances) {
        if (!isBaked(instance, m_bakes)) wanted.insert(instance.asset);
    }
}

}  // namespace rubble
