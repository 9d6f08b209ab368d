#include "editor/Baker.h"

#include "core/fracture/VoronoiPartition.h"

namespace rubble {

namespace {

/// Fills in seeds, triangulation and partition.
Status makePattern(BakedPattern& pattern, const TaskContext& task) {
    const Result<Prism> prism = validated(pattern.asset->prism);
    if (!prism) return prism.error();
    Result<Seeds> seeds = seedsOf(pattern.asset->pattern, prism->outline, task.stage(0.0, 0.4));
    if (!seeds) return seeds.error();
    pattern.seeds = std::move(*seeds);
    Result<Delaunay> triangulation = triangulate(pattern.seeds.positions, task.stage(0.4, 0.8));
    if (!triangulation) return triangulation.error();
    pattern.triangulation = std::move(*triangulation);
    Result<Partition> partition = voronoiPartition(prism->outline, pattern.triangulation, task.stage(0.8, 1.0));
    if (!partition) return partition.error();
    pattern.partition = std::move(*partition);
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

BakeQueue::Delivery fragmentsOf(Bakes& bakes, std::shared_ptr<const Asset> asset, const TaskContext& task) {
    auto baked = std::make_shared<BakedAsset>();
    baked->asset = std::move(asset);
    Result<Bake> bake = rubble::bake(*baked->asset, task);
    if (!bake && bake.error().code == ErrorCode::Cancelled) return {};
    if (bake) {
        baked->bake = std::make_shared<const Bake>(std::move(*bake));
    } else {
        baked->fault = bake.error();
    }
    return [&bakes, baked] { bakes.set(baked->asset->id, baked); };
}

}  // namespace

Baker::Baker(const Document& document, const Selection& selection, Bakes& bakes, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_bakes(bakes),
      m_patterns(document, selection, BakeQueue::Start::AtOnce,
                 [&bakes](auto asset, const TaskContext& task) { return patternOf(bakes, std::move(asset), task); }),
      m_fragments(document, selection, BakeQueue::Start::AfterRest, [&bakes](auto asset, const TaskContext& task) {
          return fragmentsOf(bakes, std::move(asset), task);
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
    m_patterns.want(wanted);
    m_fragments.want(wanted);
}

}  // namespace rubble
