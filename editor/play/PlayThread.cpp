#include "editor/play/PlayThread.h"

#include "core/base/OutOfMemory.h"
#include "core/base/limits/Threads.h"
#include "core/sound/session/SoundRecorder.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace rubble {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr double kMaxShownFor = 1.0;  // s

/// Appends a newer update to an older one.
void merge(PlayUpdate& update, PlayUpdate&& newer) {
    if (newer.discardAfter) {
        const std::uint64_t last = *newer.discardAfter;
        update.discardAfter = std::min(update.discardAfter.value_or(last), last);
        std::erase_if(update.events, [last](const auto& events) { return events->step > last; });
        std::erase_if(update.costs, [last](const StepCost& cost) { return cost.step > last; });
    }
    const auto append = [](auto& to, auto& from) {
        to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
    };
    append(update.events, newer.events);
    append(update.costs, newer.costs);
    append(update.diagnostics, newer.diagnostics);
    if (newer.frame) update.frame = std::move(newer.frame);
    if (newer.shot) update.shot = std::move(newer.shot);
    update.isReplayOver |= newer.isReplayOver;
    update.isBranchKept |= newer.isBranchKept;
}

}  // namespace

double shownDuration(double computed, double interval) {
    return std::clamp(computed, interval, std::max(interval, kMaxShownFor));
}

PlayThread::PlayThread(QObject* parent)
    : QObject(parent), m_forecasts([this](const Throw& thrown, std::vector<BodyForecast> bodies) {
          post([thrown, bodies = std::move(bodies)](PlayEngine& engine) { engine.setForecast(thrown, bodies); });
      }) {}

PlayThread::~PlayThread() {
    {
        const std::lock_guard lock(m_mutex);
        m_isQuitting = true;
        cancelAll();
    }
    m_wake.notify_all();
    if (m_thread.joinable()) m_thread.join();  // it uses the other members
}

void PlayThread::cancelAll() {
    m_cancelStart.cancel();
    m_cancelSeek.cancel();
    m_forecasts.cancel();
}

/// Emits `failed` once the caller has returned to the event loop.
void PlayThread::failLater(const Error& error) {
    QMetaObject::invokeMethod(
        this, [this, sentence = QString::fromStdString(error.message)] { emit failed(sentence); },
        Qt::QueuedConnection);
}

/// Replaces the engine by another, or by none.
void PlayThread::restartWith(EngineFactory factory) {
    const std::lock_guard lock(m_mutex);
    if (factory && !m_thread.joinable()) m_thread = startedThread([this] { run(); });
    if (factory && !m_thread.joinable()) return failLater(outOfThreads("starting the simulation"));
    cancelAll();
    m_isStopping = m_thread.joinable();
    m_isStarted = factory != nullptr;
    m_factory = std::move(factory);
    m_work.clear();
    m_recorded.reset();
    m_isRecordedShown = false;
    m_update = {};
    m_wake.notify_all();
}

void PlayThread::start(EngineFactory factory) { restartWith(std::move(factory)); }

void PlayThread::stop() {
    setPlaying(false);
    restartWith(nullptr);
}

bool PlayThread::isStarted() const {
    const std::lock_guard lock(m_mutex);
    return m_isStarted;
}

void PlayThread::post(Task task) {
    const std::lock_guard lock(m_mutex);
    if (!m_isStarted) return;
    m_work.push_back({.task = std::move(task), .step = {}});
    m_wake.notify_all();
}

/// The recorded frame is made here, since the thread may be amid a step that takes long, and signalled as others are:
/// once the caller has returned to the event loop.
void PlayThread::seek(std::uint64_t step) {
    std::shared_ptr<const RecordedFrames> recorded;
    {
        const std::lock_guard lock(m_mutex);
        recorded = m_recorded;
    }
    std::optional<PlayFrame> frame = recorded ? recorded->frameUntil(step) : std::nullopt;
    const std::lock_guard lock(m_mutex);
    if (!m_isStarted) return;
    if (!m_work.empty() && m_work.back().step) m_work.pop_back();
    if (m_work.empty()) m_cancelSeek.cancel();  // of a running seek
    m_work.push_back({.task = {}, .step = step});
    m_wake.notify_all();
    m_isRecordedShown = frame && recorded == m_recorded;
    if (!m_isRecordedShown) return;
    frame->shownFrom = nowLocked();
    m_update.frame = std::move(frame);
    if (std::exchange(m_isUpdateSignalled, true)) return;
    QMetaObject::invokeMethod(
        this, [this] { emit updateReady(); }, Qt::QueuedConnection);
}

void PlayThread::setPlaying(bool isPlaying) {
    const std::lock_guard lock(m_mutex);
    if (m_isPlaying == isPlaying) return;
    m_isPlaying = isPlaying;
    m_due = nowLocked() + interval();
    m_wake.notify_all();
}

void PlayThread::setTimeScale(double scale) {
    const std::lock_guard lock(m_mutex);
    m_timeScale = scale;
    m_due = std::min(m_due, nowLocked() + interval());
    m_wake.notify_all();
}

double PlayThread::interval() const { return m_stepLength / m_timeScale; }

double PlayThread::nowLocked() const {
    if (m_isStepped) return m_steppedNow;
    return Seconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double PlayThread::now() const {
    const std::lock_guard lock(m_mutex);
    return nowLocked();
}

double PlayThread::stepLength() const {
    const std::lock_guard lock(m_mutex);
    return m_stepLength;
}

void PlayThread::useSteppedClock() {
    const std::lock_guard lock(m_mutex);
    m_isStepped = true;
}

void PlayThread::advance(double seconds) {
    std::unique_lock lock(m_mutex);
    m_steppedNow += seconds;
    m_wake.notify_all();
    m_idle.wait(lock, [this] { return !m_isBusy && !isWorkWaiting(); });
}

void PlayThread::settle() { advance(0.0); }

PlayUpdate PlayThread::takeUpdate() {
    const std::lock_guard lock(m_mutex);
    m_isUpdateSignalled = false;
    return std::exchange(m_update, {});
}

bool PlayThread::isWorkWaiting() const {
    if (m_isQuitting || m_isStopping || m_factory) return true;
    if (!m_hasEngine) return false;
    constexpr double kSlack = 1e-9;  // s: sums of step lengths are rounded
    return !m_work.empty() || (m_isPlaying && !m_isResting && nowLocked() + kSlack >= m_due);
}

void PlayThread::run() {
    lowerThreadPriority();  // pictures go on where steps take long
    std::unique_lock lock(m_mutex);
    while (!m_isQuitting) {
        if (isWorkWaiting()) {
            m_isBusy = true;
            const Status worked = orOutOfMemory("simulating", [&]() -> Status {
                work(lock);
                return success();
            });
            if (!worked) {
                if (!lock.owns_lock()) lock.lock();
                stopAfter(worked.error());
            }
            m_isBusy = false;
            continue;
        }
        m_idle.notify_all();
        const bool isTimed = !m_isStepped && m_hasEngine && m_isPlaying && !m_isResting;
        const auto hasWork = [this] { return isWorkWaiting(); };
        if (isTimed) {
            m_wake.wait_for(lock, Seconds(m_due - nowLocked()), hasWork);
        } else {
            m_wake.wait(lock, hasWork);
        }
    }
    lock.unlock();
    m_engine.reset();
}

/// Ends the simulation because of an error.
void PlayThread::stopAfter(const Error& error) {
    m_engine.reset();
    m_isStarted = m_hasEngine = false;
    m_work.clear();
    m_recorded.reset();
    emit failed(QString::fromStdString(error.message));
}

void PlayThread::work(std::unique_lock<std::mutex>& lock) {
    if (m_isStopping || m_factory) return createEngine(lock);
    if (m_work.empty()) return playStep(lock);
    m_work.front().step ? runSeek(lock) : runTasks(lock);
}

/// Runs the tasks before the next seek.
void PlayThread::runTasks(std::unique_lock<std::mutex>& lock) {
    std::vector<Task> tasks;
    for (; !m_work.empty() && !m_work.front().step; m_work.pop_front()) tasks.push_back(std::move(m_work.front().task));
    lock.unlock();
    for (const Task& task : tasks) task(*m_engine);
    const bool isResting = m_engine->isAtRest();
    lock.lock();
    if (std::exchange(m_isResting, isResting) && !isResting) m_due = nowLocked() + interval();
    if ((!m_isPlaying || m_isResting) && !isSeekWaiting()) publish(lock, 0.0);
}

void PlayThread::runSeek(std::unique_lock<std::mutex>& lock) {
    m_cancelSeek = CancelToken();
    const std::uint64_t step = *m_work.front().step;
    m_work.pop_front();
    const TaskContext task{.cancel = m_cancelSeek};
    lock.unlock();
    m_engine->seek(step, task);
    lock.lock();
    m_isResting = false;
    m_due = nowLocked() + interval();
    // Of a later seek, the recorded frame is shown: on the way to it there is nothing to see.
    if (!isSeekWaiting() || !m_isRecordedShown) publish(lock, 0.0);
}

bool PlayThread::isSeekWaiting() const {
    return std::ranges::any_of(m_work, [](const Work& work) { return work.step.has_value(); });
}

/// Destroys the engine and creates the requested one, if any.
void PlayThread::createEngine(std::unique_lock<std::mutex>& lock) {
    const EngineFactory factory = std::exchange(m_factory, nullptr);
    m_isStopping = m_hasEngine = m_isResting = false;
    m_cancelStart = CancelToken();
    const TaskContext task{.cancel = m_cancelStart};
    lock.unlock();
    m_engine.reset();
    if (!factory) return lock.lock();
    Result<std::unique_ptr<PlayEngine>> made = factory(task);
    lock.lock();
    if (m_isQuitting || m_isStopping || m_factory) return;  // superseded meanwhile
    if (!made) {
        stopAfter(made.error());
        return;
    }
    m_engine = std::move(*made);
    m_hasEngine = true;
    m_recorded = m_engine->recordedFrames();
    m_stepLength = m_engine->session().stepLength();
    m_due = nowLocked() + interval();
    emit started();
    publish(lock, 0.0);
}

/// A step that takes longer than it shows is shown as slowly as it was computed, so that motion stays smooth.
void PlayThread::playStep(std::unique_lock<std::mutex>& lock) {
    const double started = nowLocked();
    lock.unlock();
    const bool isStep = m_engine->advance();
    const bool isResting = m_engine->isAtRest();
    const std::vector<SoundCue> cues = isStep ? cuesOf(m_engine->session()) : std::vector<SoundCue>();
    lock.lock();
    const double shownFor = shownDuration(nowLocked() - started, interval());
    if (!cues.empty()) {
        lock.unlock();
        emit cuesPlayed(cues, shownFor);
        lock.lock();
    }
    m_due = std::max(m_due + interval(), nowLocked());
    m_isResting = isResting;
    const bool isReplayOver = m_engine->isAtScriptEnd();
    if (isReplayOver) m_isPlaying = false;
    m_update.isReplayOver |= isReplayOver;
    publish(lock, isStep ? shownFor : 0.0);
}

void PlayThread::publish(std::unique_lock<std::mutex>& lock, double shownFor) {
    lock.unlock();
    PlayUpdate update = m_engine->takeUpdate();
    lock.lock();
    if (m_isStopping || m_factory) return;
    if (update.order) m_forecasts.start(std::exchange(update.order, nullptr));
    const bool isSuperseded = m_isRecordedShown && isSeekWaiting();  // by a seek that came meanwhile
    if (isSuperseded) {
        update.frame.reset();
        return merge(m_update, std::move(update));
    }
    update.frame->shownFrom = nowLocked();
    update.frame->shownFor = shownFor;
    merge(m_update, std::move(update));
    if (std::exchange(m_isUpdateSignalled, true)) return;
    emit updateReady();
}

}  // namespace rubble

#include "moc_PlayThread.cpp"
