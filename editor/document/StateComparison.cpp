#include "editor/document/StateComparison.h"

#include <QMetaObject>

#include <algorithm>

namespace rubble {

namespace {

/// The asset as it was; null where it was not there.
const Asset* earlierOf(const Asset& asset, const Project& earlier, const Project& now) {
    const std::vector<AssetPair> pairs = assetPairs(earlier, now);
    const auto pair = std::ranges::find(pairs, &asset, &AssetPair::after);
    return pair != pairs.end() ? pair->before : nullptr;
}

}  // namespace

StateComparison::StateComparison(const Document& document, const Selection& selection, const Bakes& bakes,
                                 QObject* parent)
    : QObject(parent), m_document(document), m_selection(selection), m_bakes(bakes) {
    m_thread.setMaxThreadCount(1);
    connect(&selection, &Selection::assetChanged, this, &StateComparison::takeAsset);
    connect(&document, &Document::changed, this, [this](const Changes& changes) {
        if (changes.touches(Part::Asset) || changes.touches(Part::Material)) compare();
    });
    connect(&bakes, &Bakes::changed, this, [this](Id asset) {
        if (asset == m_selection.asset()) compare();
    });
}

StateComparison::~StateComparison() {
    m_cancel.cancel();
    m_thread.waitForDone();
}

void StateComparison::begin(std::shared_ptr<const Project> earlier, const QString& name) {
    m_earlier = std::move(earlier);
    m_name = name;
    takeAsset();
}

void StateComparison::end() {
    if (!isOn()) return;
    m_earlier = nullptr;
    takeAsset();
}

void StateComparison::takeAsset() {
    m_before = nullptr;
    m_bakedId = 0;
    m_compared = nullptr;
    compare();
    emit changed();
}

void StateComparison::compare() {
    m_cancel.cancel();
    m_cancel = CancelToken();
    const int run = ++m_run;
    const Asset* asset = findAsset(m_document.project(), m_selection.asset());
    const auto baked = m_bakes.find(m_selection.asset());
    const bool isBaked = asset && baked && baked->bake && *baked->asset == *asset;
    if (!isOn() || !isBaked) return;
    const Asset* was = earlierOf(*asset, *m_earlier, m_document.project());
    auto compared = std::make_shared<ComparedAsset>();
    compared->wasThere = was != nullptr;
    compared->after = baked->bake;
    if (was) compared->recipe = recipeChanges(*m_earlier, *was, m_document.project(), *asset);
    const std::shared_ptr<const Bake> known = was && m_bakedId == was->id ? m_before : nullptr;
    m_thread.start([this, run, compared, known, earlier = m_earlier, was, task = TaskContext{.cancel = m_cancel}] {
        std::optional<Error> fault;
        std::shared_ptr<const Bake> before = known;
        if (was && !before) {
            Result<Bake> made = bake(*was, task);
            if (made) before = std::make_shared<const Bake>(std::move(*made));
            if (!made) fault = made.error();
        }
        compared->before = before;
        if (before) compared->pieces = differenceOf(*before, *compared->after);
        const Id id = was ? was->id : 0;
        QMetaObject::invokeMethod(this, [this, run, compared, fault, id] {
            if (run != m_run) return;
            if (fault) return emit said(QString::fromStdString(fault->message));
            m_before = compared->before;
            m_bakedId = id;
            m_compared = compared;
            emit changed();
        });
    });
}

}  // namespace rubble
