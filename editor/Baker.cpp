#include "editor/Baker.h"

#include <QMetaObject>
#include <QThread>

#include <algorithm>

namespace rubble {

namespace {

constexpr qint64 kTooLateMilliseconds = 200;  // a bake older than that is given up when its asset changes
constexpr double kProgressStep = 0.01;        // smaller steps are not told

std::shared_ptr<const BakedAsset> baked(std::shared_ptr<const Asset> asset, const TaskContext& task) {
    auto result = std::make_shared<BakedAsset>();
    result->asset = std::move(asset);
    Result<Bake> bake = rubble::bake(*result->asset, task);
    if (!bake) {
        result->fault = bake.error();
        return result;
    }
    Result<Delaunay> triangulation = triangulate(bake->breakings[0].seeds.positions, task);
    if (triangulation) result->triangulation = std::move(*triangulation);
    result->bake = std::make_shared<const Bake>(std::move(*bake));
    return result;
}

}  // namespace

Baker::Baker(const Document& document, const Selection& selection, Bakes& bakes, QObject* parent)
    : QObject(parent), m_document(document), m_selection(selection), m_bakes(bakes) {
    m_thread.setMaxThreadCount(1);
    connect(&document, &Document::changed, this, &Baker::take);
    take({{}, true});
}

Baker::~Baker() {
    m_cancel.cancel();
    m_thread.waitForDone();
}

void Baker::cancel() {
    m_waiting.clear();
    m_cancel.cancel();
}

void Baker::take(const Changes& changes) {
    if (changes.isEverything) {
        std::vector<Id> known;
        for (const auto& [asset, result] : m_bakes.all()) known.push_back(asset);
        for (const Id asset : known) m_bakes.remove(asset);
        for (const Asset& asset : m_document.project().assets) want(asset.id);
    }
    for (const Change& change : changes.list) {
        if (change.part != Part::Asset) continue;
        if (change.kind == ChangeKind::Removed) m_bakes.remove(change.id);
        want(change.id);
    }
    startNext();
}

void Baker::want(Id asset) {
    m_waiting.insert(asset);
    if (asset == m_running && m_runningSince.hasExpired(kTooLateMilliseconds)) m_cancel.cancel();
}

void Baker::startNext() {
    if (m_running != 0) return;
    std::erase_if(m_waiting, [&](Id asset) { return !findAsset(m_document.project(), asset); });
    if (m_waiting.empty()) return emit progressed(0, 1.0);
    m_running = m_waiting.contains(m_selection.asset()) ? m_selection.asset() : *m_waiting.begin();
    m_waiting.erase(m_running);
    m_runningSince.start();
    m_cancel = CancelToken();
    emit progressed(m_running, 0.0);

    TaskContext task;
    task.cancel = m_cancel;
    task.threads = std::max(1, QThread::idealThreadCount());
    task.progress = [this, asset = m_running, told = 0.0](double fraction) mutable {
        if (fraction < told + kProgressStep) return;
        told = fraction;
        QMetaObject::invokeMethod(this, [this, asset, fraction] {
            if (asset == m_running) emit progressed(asset, fraction);
        });
    };
    auto asset = std::make_shared<const Asset>(*findAsset(m_document.project(), m_running));
    m_thread.start([this, asset = std::move(asset), task = std::move(task)]() mutable {
        const Id id = asset->id;
        std::shared_ptr<const BakedAsset> result = baked(std::move(asset), task);
        QMetaObject::invokeMethod(this,
                                  [this, id, result = std::move(result)]() mutable { finish(id, std::move(result)); });
    });
}

void Baker::finish(Id asset, std::shared_ptr<const BakedAsset> result) {
    m_running = 0;
    const bool isCancelled = result->fault && result->fault->code == ErrorCode::Cancelled;
    if (!isCancelled && findAsset(m_document.project(), asset)) m_bakes.set(asset, std::move(result));
    startNext();
}

}  // namespace rubble
