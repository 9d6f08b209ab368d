#include "editor/BakeQueue.h"

#include <QMetaObject>
#include <QThread>

#include <algorithm>

namespace rubble {

namespace {

constexpr qint64 kTooLateMilliseconds = 200;  // work older than that is given up when its asset changes
constexpr double kProgressStep = 0.01;        // smaller steps are not told

}  // namespace

BakeQueue::BakeQueue(const Document& document, const Selection& selection, Start start, Preparation prepare,
                     QObject* parent)
    : QObject(parent), m_document(document), m_selection(selection), m_start(start), m_prepare(std::move(prepare)) {
    m_thread.setMaxThreadCount(1);
    m_thread.setExpiryTimeout(-1);
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, &BakeQueue::startNext);
}

BakeQueue::~BakeQueue() {
    m_cancel.cancel();
    m_thread.waitForDone();
}

void BakeQueue::want(const std::set<Id>& assets) {
    m_waiting.insert(assets.begin(), assets.end());
    if (assets.contains(m_running) && m_runningSince.hasExpired(kTooLateMilliseconds)) m_cancel.cancel();
    if (m_start == Start::AfterRest && m_lastMilliseconds > 0) {
        m_rest.start(static_cast<int>(std::min(m_lastMilliseconds, kTooLateMilliseconds)));
    }
    startNext();
}

void BakeQueue::cancel() {
    m_waiting.clear();
    m_cancel.cancel();
}

void BakeQueue::startNext() {
    if (m_running != 0 || m_rest.isActive()) return;
    std::erase_if(m_waiting, [&](Id asset) { return !findAsset(m_document.project(), asset); });
    if (m_waiting.empty()) return emit progressed(0, 1.0);
    m_running = m_waiting.contains(m_selection.asset()) ? m_selection.asset() : *m_waiting.begin();
    m_waiting.erase(m_running);
    m_runningSince.start();
    m_cancel = CancelToken();
    emit progressed(m_running, 0.0);

    Work work = m_prepare(std::make_shared<const Asset>(*findAsset(m_document.project(), m_running)));
    m_thread.start([this, id = m_running, work = std::move(work), task = taskContext()] {
        Delivery deliver = work(task);
        QMetaObject::invokeMethod(this, [this, id, deliver = std::move(deliver)] { finish(id, deliver); });
    });
}

TaskContext BakeQueue::taskContext() {
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
    return task;
}

void BakeQueue::finish(Id asset, const Delivery& deliver) {
    m_running = 0;
    m_lastMilliseconds = m_runningSince.elapsed();
    if (deliver && findAsset(m_document.project(), asset)) deliver();
    startNext();
}

}  // namespace rubble
