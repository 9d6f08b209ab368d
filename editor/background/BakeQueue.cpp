#include "editor/background/BakeQueue.h"

#include <algorithm>
#include <utility>

namespace rubble {

namespace {

constexpr qint64 kLongMilliseconds = 200;  // work that has run longer is cancelled when its asset changes

}  // namespace

BakeQueue::BakeQueue(const Document& document, const Selection& selection, Start start, Preparation prepare,
                     QObject* parent)
    : QObject(parent), m_document(document), m_selection(selection), m_start(start), m_prepare(std::move(prepare)) {
    m_delay.setSingleShot(true);
    connect(&m_delay, &QTimer::timeout, this, &BakeQueue::startNext);
    connect(&m_job, &BackgroundJob::progressed, this, [this](double fraction) { emit progressed(m_asset, fraction); });
    connect(&m_job, &BackgroundJob::failed, this, [this] { finish({}); });
}

void BakeQueue::add(const std::set<Id>& assets) {
    m_queued.insert(assets.begin(), assets.end());
    if (m_start == Start::WhenIdle && m_lastMilliseconds > 0) {
        m_delay.start(static_cast<int>(std::min(m_lastMilliseconds, kLongMilliseconds)));
    }
    if (isBusy() && assets.contains(m_asset) && m_runningSince.hasExpired(kLongMilliseconds)) cancelRunning();
    startNext();
}

void BakeQueue::cancel() {
    m_queued.clear();
    if (!isBusy()) return;
    cancelRunning();
    startNext();
}

void BakeQueue::cancelRunning() {
    m_job.cancel();
    m_lastMilliseconds = m_runningSince.elapsed();
}

void BakeQueue::startNext() {
    if (isBusy() || m_delay.isActive()) return;
    std::erase_if(m_queued, [&](Id asset) { return !findAsset(m_document.project(), asset); });
    if (m_queued.empty()) return emit progressed(0, 1.0);
    m_asset = m_queued.contains(m_selection.asset()) ? m_selection.asset() : *m_queued.begin();
    m_queued.erase(m_asset);
    m_runningSince.start();
    m_job.start(m_prepare(std::make_shared<const Asset>(*findAsset(m_document.project(), m_asset))),
                [this](const Delivery& deliver) { finish(deliver); });
    emit progressed(m_asset, 0.0);
}

void BakeQueue::finish(const Delivery& deliver) {
    m_lastMilliseconds = m_runningSince.elapsed();
    if (deliver && findAsset(m_document.project(), m_asset)) deliver();
    startNext();
}

}  // namespace rubble

#include "moc_BakeQueue.cpp"
