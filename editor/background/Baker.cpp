#include "editor/background/Baker.h"

#include "core/asset/bake/BakeEstimate.h"
#include "core/asset/bake/BakeHash.h"
#include "core/asset/bake/FractureResult.h"
#include "core/asset/project/FragmentLevels.h"
#include "core/base/MessageText.h"
#include "core/base/OutOfMemory.h"
#include "editor/document/EnteredFragment.h"

#include <algorithm>

namespace rubble {

namespace {

/// A pattern to compute for an asset.
struct PatternRequest {
    std::shared_ptr<const Asset> asset;
    FragmentPath parent;                         // the fragment to break; empty: the whole
    FragmentSolid solid;                         // of that fragment
    std::shared_ptr<const BakedPattern> before;  // the previous result; null if there is none
};

/// The pattern of the entered fragment; nothing if none is entered.
std::optional<PatternRequest> enteredFragmentRequest(std::shared_ptr<const Asset> asset, const Selection& selection,
                                                     const Bakes& bakes) {
    const FragmentPath& parent = selection.enteredFragment();
    if (asset->id != selection.asset() || parent.empty() || !levelFor(*asset, parent, levelOf(parent)))
        return std::nullopt;
    std::optional<FragmentSolid> solid = fragmentSolid(bakes, asset->id, parent);
    if (!solid) return std::nullopt;
    return PatternRequest{std::move(asset), parent, std::move(*solid), nullptr};
}

Result<PlanarFracture> cutFor(const PatternRequest& request, const TaskContext& task) {
    const Asset& asset = *request.asset;
    if (request.parent.empty()) return planarFracture(recipeOf(asset), asset.prism(), task);
    const std::string id = std::to_string(asset.id) + "/" + request.parent;
    const Level& level = *levelFor(asset, request.parent, levelOf(request.parent));
    return planarFracture(recipeOf(asset, id, level, Vec3(request.solid.offset, 0.0)), request.solid.prism, task);
}

/// Whether the whole of both has the same pattern: edits of deeper levels do not change it.
bool isSameWhole(const Asset& a, const Asset& b) {
    return isSameShape(a, b) && a.pattern == b.pattern && a.shaping == b.shaping && a.edits == b.edits;
}

/// Null if cancelled.
std::shared_ptr<const BakedPattern> patternOf(const PatternRequest& request, const TaskContext& task) {
    auto pattern = std::make_shared<BakedPattern>();
    const bool isKnown = request.before && isSameWhole(*request.before->asset, *request.asset);
    if (isKnown) *pattern = *request.before;
    pattern->asset = request.asset;
    if (isKnown) return pattern;
    if (!request.parent.empty()) {
        pattern->asset =
            std::make_shared<const Asset>(fragmentAsAsset(*request.asset, request.parent, request.solid.prism));
        pattern->parent = request.parent;
        pattern->offset = request.solid.offset;
    }
    Result<PlanarFracture> cut = orOutOfMemory("computing the pattern", [&] { return cutFor(request, task); });
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

/// The pattern on display is computed first.
BakeQueue::Work patternWork(const std::shared_ptr<const Asset>& asset, const Selection& selection, Bakes& bakes) {
    std::vector<PatternRequest> requests;
    if (std::optional<PatternRequest> entered = enteredFragmentRequest(asset, selection, bakes))
        requests.push_back(std::move(*entered));
    if (asset->isPrism()) requests.push_back({asset, {}, {}, bakes.findPattern(asset->id)});
    return [&bakes, requests = std::move(requests)](const TaskContext& task) -> BakeQueue::Delivery {
        std::vector<std::shared_ptr<const BakedPattern>> patterns;
        for (const PatternRequest& request : requests) {
            patterns.push_back(patternOf(request, task));
            if (!patterns.back()) return {};
        }
        return [&bakes, patterns = std::move(patterns)] {
            for (const auto& pattern : patterns) bakes.setPattern(pattern->asset->id, pattern);
        };
    };
}

/// The variants of an asset to bake, and its known bakes.
struct BakeRequest {
    std::shared_ptr<const Asset> asset;
    std::vector<std::uint32_t> variants;  // ascending from 0
    std::vector<std::shared_ptr<const Bake>> known;
    std::size_t otherBakes = 0;  // of other assets, which are kept
    double otherBytes = 0.0;
};

void countOthers(const Bakes& bakes, BakeRequest& request) {
    for (const auto& [key, bake] : bakes.assetBakes()) {
        if (key.asset == request.asset->id) continue;
        ++request.otherBakes;
        request.otherBytes +=
            BakeEstimate{static_cast<double>(bake->fragmentCount()), static_cast<double>(bake->fractures.size())}
                .bytes();
    }
}

std::optional<Error> totalFault(const BakeRequest& request) {
    const double own = static_cast<double>(request.variants.size()) * estimateOf(*request.asset).bytes();
    const std::optional<std::string> fault =
        totalSizeFault(request.otherBakes + request.variants.size(), request.otherBytes + own);
    if (!fault) return std::nullopt;
    return Error{ErrorCode::Limit, "Asset \"" + request.asset->name + "\": " + *fault};
}

BakeRequest requestFor(std::shared_ptr<const Asset> asset, const Project& project, const Bakes& bakes) {
    BakeRequest request{.asset = std::move(asset)};
    for (const auto& [id, variant] : usedVariants(project)) {
        if (id == request.asset->id) request.variants.push_back(variant);
    }
    countOthers(bakes, request);
    const auto before = bakes.find(request.asset->id);
    if (!before) return request;
    if (before->bake) request.known.push_back(before->bake);
    for (const auto& [variant, bake] : before->variants) request.known.push_back(bake);
    return request;
}

/// The bake of a variant; a known one if its input has not changed.
Result<std::shared_ptr<const Bake>> bakeOf(const Asset& variant, const BakeRequest& request, const TaskContext& task) {
    const auto isSame = [input = bakeInputHash(variant)](const auto& bake) { return bake->input == input; };
    if (const auto same = std::ranges::find_if(request.known, isSame); same != request.known.end()) return *same;
    Result<Bake> made =
        orOutOfMemory("fracturing asset " + quotedName(variant.name), [&] { return bake(variant, task); });
    if (!made) return made.error();
    return std::make_shared<const Bake>(std::move(*made));
}

BakeQueue::Delivery fragmentsOf(Bakes& bakes, const BakeRequest& request, const TaskContext& task) {
    auto baked = std::make_shared<BakedAsset>();
    baked->asset = request.asset;
    baked->fault = totalFault(request);
    const auto count = static_cast<double>(request.variants.size());
    for (std::size_t k = 0; k < request.variants.size() && !baked->fault; ++k) {
        const std::uint32_t variant = request.variants[k];
        const TaskContext part = task.stage(static_cast<double>(k) / count, static_cast<double>(k + 1) / count);
        Result<std::shared_ptr<const Bake>> made = bakeOf(variantOf(*request.asset, variant), request, part);
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
      m_patterns(document, selection, BakeQueue::Start::Immediately,
                 [&selection, &bakes](const auto& asset) { return patternWork(asset, selection, bakes); }),
      m_fragments(document, selection, BakeQueue::Start::WhenIdle, [&bakes, &document](auto asset) {
          return [&bakes, request = requestFor(std::move(asset), document.project(), bakes)](const TaskContext& task) {
              return fragmentsOf(bakes, request, task);
          };
      }) {
    connect(&document, &Document::changed, this, &Baker::bakeChanged);
    connect(&selection, &Selection::enteredFragmentChanged, this, [this] { bakeEnteredFragment(); });
    connect(&bakes, &Bakes::changed, this, [this](Id asset) {
        if (asset == m_selection.asset()) bakeEnteredFragment();
    });
    connect(&m_fragments, &BakeQueue::progressed, this, &Baker::progressed);
    bakeChanged({{}, true});
}

void Baker::cancel() {
    m_patterns.cancel();
    m_fragments.cancel();
}

void Baker::bakeChanged(const Changes& changes) {
    std::set<Id> stale;
    if (changes.isEverything) {
        m_bakes.clear();
        for (const Asset& asset : m_document.project().assets) stale.insert(asset.id);
    }
    for (const Change& change : changes.list) {
        if (change.part != Part::Asset) continue;
        if (change.kind == ChangeKind::Removed) {
            m_bakes.remove(change.id);
        } else {
            stale.insert(change.id);
        }
    }
    if (!stale.empty()) m_patterns.add(stale);
    if (changes.touches(Part::Instance)) addUnbaked(stale);
    if (!stale.empty()) m_fragments.add(stale);
}

/// The entered fragment, or its outline, may have changed.
void Baker::bakeEnteredFragment() {
    if (!m_selection.enteredFragment().empty()) m_patterns.add({m_selection.asset()});
}

/// Adds the assets of instances whose variant is not baked.
void Baker::addUnbaked(std::set<Id>& stale) const {
    for (const Instance& instance : m_document.project().instances) {
        if (!isBaked(instance, m_bakes)) stale.insert(instance.asset);
    }
}

}  // namespace rubble

#include "moc_Baker.cpp"
