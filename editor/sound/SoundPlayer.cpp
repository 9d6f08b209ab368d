#include "editor/sound/SoundPlayer.h"

#include "core/base/OutOfMemory.h"
#include "core/base/limits/Threads.h"

#include <algorithm>

namespace rubble {

SoundPlayer::SoundPlayer(QObject* parent) : QObject(parent) {
    connect(&m_stream, &SoundStreamDevice::quietChanged, this, &SoundPlayer::updateOutput, Qt::QueuedConnection);
}

SoundPlayer::~SoundPlayer() {
    m_output.stop();
    {
        const std::lock_guard lock(m_mutex);
        m_isQuitting = true;
    }
    m_wake.notify_all();
    if (m_thread.joinable()) m_thread.join();  // it uses the other members
}

void SoundPlayer::setOutputUse(OutputUse use) {
    m_use = use;
    updateOutput();
}

/// While the device is stopped, its stream stands still: of a cue that comes then, nothing is lost.
void SoundPlayer::updateOutput() {
    const bool isOn = m_use == OutputUse::Always || (m_use == OutputUse::WhileHeard && !m_stream.isQuiet());
    isOn ? m_output.start(m_stream) : m_output.stop();
}

void SoundPlayer::setHearing(bool isHearing) {
    const std::lock_guard lock(m_mutex);
    if (std::exchange(m_isHearing, isHearing) == isHearing || isHearing) return;
    m_waiting.clear();
    m_stream.silence();
}

void SoundPlayer::play(const std::vector<SoundCue>& cues, double after) {
    const std::lock_guard lock(m_mutex);
    if (!m_isHearing || cues.empty()) return;
    if (!m_thread.joinable()) m_thread = startedThread([this] { run(); });
    if (!m_thread.joinable()) return;
    const Clock::time_point due =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(after));
    for (const SoundCue& cue : cues) m_waiting.push_back({cue, due});
    while (m_waiting.size() > kMaxWaiting) m_waiting.pop_front();
    m_wake.notify_all();
}

void SoundPlayer::finishSamples() {
    std::unique_lock lock(m_mutex);
    m_idle.wait(lock, [this] { return m_waiting.empty() && !m_isBusy; });
}

/// Makes the samples. Where memory runs out, a cue is not heard.
void SoundPlayer::run() {
    std::unique_lock lock(m_mutex);
    while (true) {
        m_wake.wait(lock, [this] { return !m_waiting.empty() || m_isQuitting; });
        if (m_isQuitting) return;
        Waiting next = std::move(m_waiting.front());
        m_waiting.pop_front();
        m_isBusy = true;
        lock.unlock();
        SharedSample sample;
        (void)orOutOfMemory("making a sound", [&]() -> Status {
            sample = sampleOf(next.cue, m_count++, m_cache);
            return success();
        });
        lock.lock();
        next.cue.time = std::max(0.0, std::chrono::duration<double>(next.due - Clock::now()).count());
        if (sample && m_isHearing) m_stream.add(next.cue, std::move(sample));
        m_isBusy = false;
        if (m_waiting.empty()) m_idle.notify_all();
    }
}

}  // namespace rubble

#include "moc_SoundPlayer.cpp"
