#include "editor/background/DerivedState.h"

#include <algorithm>
#include <utility>

namespace rubble {

DerivedState::DerivedState(DerivedFrom from, QObject* parent) : QObject(parent), m_from(std::move(from)) {
    m_delay.setSingleShot(true);
    m_delay.setInterval(m_from.delayMilliseconds);
    connect(&m_delay, &QTimer::timeout, this, &DerivedState::start);
    connect(&m_job, &BackgroundJob::progressed, this, &DerivedState::progressed);
    connect(&m_job, &BackgroundJob::failed, this, [this] { fail(outOfMemory(m_from.doing)); });
    connect(&m_from.document, &Document::changed, this, &DerivedState::receive);
    if (m_from.bakes) connect(m_from.bakes, &Bakes::changed, this, &DerivedState::invalidate);
}

void DerivedState::receive(const Changes& changes) {
    if (changes.isEverything && m_state != State::Idle && m_from.onChange == OnChange::Restart) return restart();
    if (std::ranges::any_of(m_from.parts, [&](Part part) { return changes.touches(part); })) invalidate();
}

void DerivedState::invalidate() {
    if (m_from.onChange == OnChange::Discard) return reset();
    if (m_state == State::Idle) return;
    m_job.cancel();
    m_state = State::Pending;
    m_delay.start();
}

void DerivedState::restart() {
    m_job.cancel();
    m_state = State::Pending;
    m_delay.start();
    if (m_hasValue || m_error) drop();
}

void DerivedState::reset() {
    m_job.cancel();
    m_delay.stop();
    const bool wasIdle = std::exchange(m_state, State::Idle) == State::Idle;
    if (!wasIdle || m_hasValue || m_error) drop();
}

void DerivedState::drop() {
    dropValue();
    m_hasValue = false;
    m_error.reset();
    emit changed();
}

void DerivedState::cancel() {
    if (!isPending()) return;
    m_job.cancel();
    m_delay.stop();
    m_state = State::Idle;
    emit changed();
}

void DerivedState::startRequested() {
    m_error.reset();
    start();
    emit changed();
    if (isPending()) emit progressed(0.0);
}

void DerivedState::start() {
    m_job.cancel();
    m_delay.stop();
    m_state = State::Pending;
    m_hasPublished = false;
    const Status started = orOutOfMemory(m_from.doing, [this] { return startJob(); });
    if (!started) fail(started.error());
}

void DerivedState::setReady() {
    m_hasValue = true;
    m_error.reset();
    m_state = State::Ready;
    emit changed();
}

void DerivedState::setPublished() {
    m_hasValue = m_hasPublished = true;
    emit changed();
}

void DerivedState::fail(Error error) {
    if (!m_hasPublished) {
        dropValue();
        m_hasValue = false;
    }
    m_error = std::move(error);
    m_state = State::Failed;
    emit changed();
    emit failed(QString::fromStdString(m_error->message));
}

}  // namespace rubble

#include "moc_DerivedState.cpp"
