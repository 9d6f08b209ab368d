#include "editor/play/PlayThread.h"

#include <chrono>
#include <utility>

namespace rubble {
namespace {

using Seconds = std::chrono::duration<double>;

/// Puts newer news behind older ones.
void join(PlayNews& news, PlayNews&& newer) {
    if (newer.forgetBeyond) {
        const std::uint64_t last = *newer.forgetBeyond;
        news.forgetBeyond = std::min(news.forgetBeyond.value_or(last), last);
        std::erase_if(news.breaks, [last](const ToldBreak& one) { return one.step > last; });
        std::erase_if(news.costs, [last](const StepCost& one) { return one.step > last; });
    }
    const auto append = [](auto& to, auto& from) {
        to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
    };
    append(news.breaks, newer.breaks);
    append(news.costs, newer.costs);
    append(news.notices, newer.notices);
    if (newer.frame) news.frame = std::move(newer.frame);
    if (newer.shot) news.shot = std::move(newer.shot);
}

}  // namespace

PlayThread::PlayThread(QObject* parent) : QObject(parent), m_thread([this] { run(); }) {}

PlayThread::~PlayThread() {
    {
        const std::lock_guard lock(m_mutex);
        m_isQuitting = true;
        cancelAll();
    }
    m_woken.notify_all();
    m_thread.join();
}

void PlayThread::cancelAll() {
    m_cancelMaking.cancel();
    m_cancelSeek.cancel();
}

/// Lets go of what is played for another, or for nothing.
void PlayThread::replaceBy(Maker maker) {
    const std::lock_guard lock(m_mutex);
    cancelAll();
    m_isStopping = true;
    m_isWanted = maker != nullptr;
    m_maker = std::move(maker);
    m_tasks.clear();
    m_seek.reset();
    m_news = {};
    m_woken.notify_all();
}

void PlayThread::start(Maker maker) { replaceBy(std::move(maker)); }

void PlayThread::stop() {
    setPlaying(false);
    replaceBy(nullptr);
}

void PlayThread::post(Task task) {
    const std::lock_guard lock(m_mutex);
    if (!m_isWanted) return;
    m_tasks.push_back(std::move(task));
    m_woken.notify_all();
}

void PlayThread::seek(std::uint64_t step) {
    const std::lock_guard lock(m_mutex);
    if (!m_isWanted) return;
    m_seek = step;
    m_cancelSeek.cancel();  // of the way to where one wanted to go before
    m_woken.notify_all();
}

void PlayThread::setPlaying(bool isPlaying) {
    const std::lock_guard lock(m_mutex);
    if (m_isPlaying == isPlaying) return;
    m_isPlaying = isPlaying;
    m_due = nowLocked() + interval();
    m_woken.notify_all();
}

void PlayThread::setTimeScale(double scale) {
    const std::lock_guard lock(m_mutex);
    m_timeScale = scale;
    m_due = std::min(m_due, nowLocked() + interval());
    m_woken.notify_all();
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
    m_woken.notify_all();
    m_idle.wait(lock, [this] { return !m_isBusy && !isWorkWaiting(); });
}

void PlayThread::settle() { advance(0.0); }

PlayNews PlayThread::takeNews() {
    const std::lock_guard lock(m_mutex);
    m_isAnnounced = false;
    return std::exchange(m_news, {});
}

bool PlayThread::isWorkWaiting() const {
    if (m_isQuitting || m_isStopping || m_maker) return true;
    if (!m_hasEngine) return false;
    constexpr double kSlack = 1e-9;  // s: sums of steps are not exact
    return !m_tasks.empty() || m_seek || (m_isPlaying && nowLocked() + kSlack >= m_due);
}

void PlayThread::run() {
    std::unique_lock lock(m_mutex);
    while (!m_isQuitting) {
        if (isWorkWaiting()) {
            m_isBusy = true;
            work(lock);
            m_isBusy = false;
            continue;
        }
        m_idle.notify_all();
        const bool isTimed = !m_isStepped && m_hasEngine && m_isPlaying;
        const auto isWoken = [this] { return isWorkWaiting(); };
        if (isTimed) {
            m_woken.wait_for(lock, Seconds(m_due - nowLocked()), isWoken);
        } else {
            m_woken.wait(lock, isWoken);
        }
    }
    lock.unlock();
    m_engine.reset();
}

void PlayThread::work(std::unique_lock<std::mutex>& lock) {
    if (m_isStopping || m_maker) return make(lock);
    if (!m_tasks.empty()) {
        const std::deque<Task> tasks = std::exchange(m_tasks, {});
        lock.unlock();
        for (const Task& task : tasks) task(*m_engine);
        lock.lock();
        if (!m_isPlaying && !m_seek) publish(lock, 0.0);
        return;
    }
    if (m_seek) {
        m_cancelSeek = CancelToken();
        const std::uint64_t step = *std::exchange(m_seek, std::nullopt);
        const TaskContext task{.cancel = m_cancelSeek};
        lock.unlock();
        m_engine->seek(step, task);
        lock.lock();
        m_due = nowLocked() + interval();
        return publish(lock, 0.0);
    }
    playStep(lock);
}

/// Lets go of the engine and makes the one that is wanted.
void PlayThread::make(std::unique_lock<std::mutex>& lock) {
    const Maker maker = std::exchange(m_maker, nullptr);
    m_isStopping = m_hasEngine = false;
    m_cancelMaking = CancelToken();
    const TaskContext task{.cancel = m_cancelMaking};
    lock.unlock();
    m_engine.reset();
    if (!maker) return lock.lock();
    Result<std::unique_ptr<PlayEngine>> made = maker(task);
    lock.lock();
    if (m_isQuitting || m_isStopping || m_maker) return;  // something else is wanted by now
    if (!made) {
        m_isWanted = false;
        m_tasks.clear();
        m_seek.reset();
        emit failed(QString::fromStdString(made.error().message));
        return;
    }
    m_engine = std::move(*made);
    m_hasEngine = true;
    m_stepLength = m_engine->session().stepLength();
    m_due = nowLocked() + interval();
    emit started();
    publish(lock, 0.0);
}

void PlayThread::playStep(std::unique_lock<std::mutex>& lock) {
    lock.unlock();
    m_engine->step();
    lock.lock();
    m_due = std::max(m_due + interval(), nowLocked());
    publish(lock, interval());
}

void PlayThread::publish(std::unique_lock<std::mutex>& lock, double shownFor) {
    lock.unlock();
    PlayNews news = m_engine->takeNews();
    lock.lock();
    if (m_isStopping || m_maker) return;
    news.frame->shownFrom = nowLocked();
    news.frame->shownFor = shownFor;
    join(m_news, std::move(news));
    if (std::exchange(m_isAnnounced, true)) return;
    emit hasNews();
}

}  // namespace rubble
