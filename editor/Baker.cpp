#include "editor/Baker.h"

#include "core/asset/Breaking.h"
#include "editor/document/Inside.h"

#include <algorithm>

namespace rubble {

namespace {

/// A pattern that is to be made of an asset.
struct PatternWish {
    std::shared_ptr<const Asset> asset;
    FragmentPath inside;                         // the fragment that is broken; empty: the whole
    FragmentSolid solid;                         // it, where it is one
    std::shared_ptr<const BakedPattern> before;  // of the same; null where there is none
};

/// That inside the fragment which is seen; none where the whole is.
std::optional<PatternWish> insideWish(std::shared_ptr<const Asset> asset, const Selection& selection,
                                      const Bakes& bakes) {
    const FragmentPath& inside = selection.inside();
    if (asset->id != selection.asset() || inside.empty() || !levelFor(*asset, inside, levelOf(inside)))
        return std::nullopt;
    std::optional<FragmentSolid> solid = solidOf(bakes, asset->id, inside);
    if (!solid) return std::nullopt;
    return PatternWish{std::move(asset), inside, std::move(*solid), nullptr};
}

Result<PlaneBreaking> cutFor(const PatternWish& wish, const TaskContext& task) {
    const Asset& asset = *wish.asset;
    if (wish.inside.empty()) return cutBy(recipeOf(asset), asset.prism, task);
    const std::string id = std::to_string(asset.id) + "/" + wish.inside;
    const Level& level = *levelFor(asset, wish.inside, levelOf(wish.inside));
    return cutBy(recipeOf(asset, id, level, wish.solid.offset), wish.solid.prism, task);
}

/// Whether the whole of both is cut alike: what is done inside fragments leaves it as it is.
bool isSameWhole(const Asset& a, const Asset& b) {
    return a.prism == b.prism && a.pattern == b.pattern && a.shaping == b.shaping && a.edits == b.edits;
}

/// Null where it was cancelled.
std::shared_ptr<const BakedPattern> patternOf(const PatternWish& wish, const TaskContext& task) {
    auto pattern = std::make_shared<BakedPattern>();
    const bool isKnown = wish.before && isSameWhole(*wish.before->asset, *wish.asset);
    if (isKnown) *pattern = *wish.before;
    pattern->asset = wish.asset;
    if (isKnown) return pattern;
    if (!wish.inside.empty()) {
        pattern->asset = std::make_shared<const Asset>(asWhole(*wish.asset, wish.inside, wish.solid.prism));
        pattern->inside = wish.inside;
        pattern->offset = wish.solid.offset;
    }
    Result<PlaneBreaking> cut = cutFor(wish, task);
    if (!cut) {
        if (cut.error().code == ErrorCode::Cancelled) return nullptr;
        pattern->fault = cut.error();
        return pattern;
    }
    pattern->seeds = std::move(cut->seeds);
    pattern->triangulation = std::move(cut->delaunay);
    pattern->partition = std::move(cut->partition);
    return pattern;
}

/// What is seen comes first.
BakeQueue::Work patternWork(const std::shared_ptr<const Asset>& asset, const Selection& selection, Bakes& bakes) {
    std::vector<PatternWish> wishes;
    if (std::optional<PatternWish> inside = insideWish(asset, selection, bakes)) wishes.push_back(std::move(*inside));
    wishes.push_back({asset, {}, {}, bakes.findPattern(asset->id)});
    return [&bakes, wishes = std::move(wishes)](const TaskContext& task) -> BakeQueue::Delivery {
        std::vector<std::shared_ptr<const BakedPattern>> patterns;
        for (const PatternWish& wish : wishes) {
            patterns.push_back(patternOf(wish, task));
            if (!patterns.back()) return {};
        }
        return [&bakes, patterns = std::move(patterns)] {
            for (const auto& pattern : patterns) bakes.setPattern(pattern->asset->id, pattern);
        };
    };
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
      m_selection(selection),
      m_bakes(bakes),
      m_patterns(document, selection, BakeQueue::Start::AtOnce,
                 [&selection, &bakes](const auto& asset) { return patternWork(asset, selection, bakes); }),
      m_fragments(document, selection, BakeQueue::Start::AfterRest, [&bakes, &document](auto asset) {
          return [&bakes, wish = wishFor(std::move(asset), document.project(), bakes)](const TaskContext& task) {
              return fragmentsOf(bakes, wish, task);
          };
      }) {
    connect(&document, &Document::changed, this, &Baker::take);
    connect(&selection, &Selection::insideChanged, this, [this] { takeInside(); });
    connect(&bakes, &Bakes::changed, this, [this](Id asset) {
        if (asset == m_selection.asset()) takeInside();
    });
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

/// The fragment that is seen may be another one, or have another outline.
void Baker::takeInside() {
    if (!m_selection.inside().empty()) m_patterns.want({m_selection.asset()});
}

/// Assets in variants that are used from now on.
void Baker::addUnbaked(std::set<Id>& wanted) const {
    for (const Instance& instance : m_document.project().instances) {
        if (!isBaked(instance, m_bakes)) wanted.insert(instance.asset);
    }
}

}  // namespace rubble
