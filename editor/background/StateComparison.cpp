#include "editor/background/StateComparison.h"

#include "core/io/project/ProjectDifference.h"

#include <algorithm>

namespace rubble {

namespace {

/// The asset in the earlier state; null if it did not exist.
const Asset* earlierOf(const Asset& asset, const Project& earlier, const Project& now) {
    const std::vector<AssetPair> pairs = assetPairs(earlier, now);
    const auto pair = std::ranges::find(pairs, &asset, &AssetPair::after);
    return pair != pairs.end() ? pair->before : nullptr;
}

}  // namespace

StateComparison::StateComparison(const Document& document, const Selection& selection, const Bakes& bakes,
                                 QObject* parent)
    : QObject(parent), m_document(document), m_selection(selection), m_bakes(bakes) {
    connect(&selection, &Selection::assetChanged, this, &StateComparison::restart);
    connect(&document, &Document::changed, this, [this](const Changes& changes) {
        if (changes.touches(Part::Asset) || changes.touches(Part::Material)) compare();
    });
    connect(&bakes, &Bakes::changed, this, [this](Id asset) {
        if (asset == m_selection.asset()) compare();
    });
}

void StateComparison::begin(std::shared_ptr<const Project> earlier, const QString& name) {
    m_earlier = std::move(earlier);
    m_name = name;
    restart();
}

void StateComparison::end() {
    if (!isOn()) return;
    m_earlier = nullptr;
    restart();
}

void StateComparison::restart() {
    m_before = nullptr;
    m_bakedId = 0;
    m_compared = nullptr;
    compare();
    emit changed();
}

void StateComparison::compare() {
    m_job.cancel();
    const Asset* asset = findAsset(m_document.project(), m_selection.asset());
    const auto baked = m_bakes.find(m_selection.asset());
    const bool isBaked = asset && baked && baked->bake && *baked->asset == *asset;
    if (!isOn() || !isBaked) return;
    const Asset* earlierAsset = earlierOf(*asset, *m_earlier, m_document.project());
    auto compared = std::make_shared<ComparedAsset>();
    compared->existedBefore = earlierAsset != nullptr;
    compared->after = baked->bake;
    if (earlierAsset) {
        compared->recipe = assetChanges(*m_earlier, *earlierAsset, m_document.project(), *asset);
        if (m_bakedId == earlierAsset->id) compared->before = m_before;
    }
    m_job.start(
        [compared, earlier = m_earlier, earlierAsset](const TaskContext& task) -> Status {
            if (earlierAsset && !compared->before) {
                Result<Bake> made = bake(*earlierAsset, {.cancel = task.cancel});
                if (!made) return made.error();
                compared->before = std::make_shared<const Bake>(std::move(*made));
            }
            if (compared->before) compared->fragments = differenceOf(*compared->before, *compared->after);
            return success();
        },
        [this, compared, id = earlierAsset ? earlierAsset->id : 0](const Status& status) {
            if (!status) return emit statusMessage(QString::fromStdString(status.error().message));
            m_before = compared->before;
            m_bakedId = id;
            m_compared = compared;
            emit changed();
        });
}

}  // namespace rubble

#include "moc_StateComparison.cpp"
