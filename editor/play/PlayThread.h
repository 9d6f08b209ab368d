#pragma once

#include "editor/play/PlayEngine.h"

#include <QObject>

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace rubble {

/// Plays on a thread of its own, at the pace of a clock: a step every `dt / timeScale` seconds. What takes longer plays slower,
/// and makes up for nothing. Tasks are carried out between steps, in order; nobody waits for them.
class PlayThread : public QObject {
    Q_OBJECT
public:
    /// Gives what is played from then on; called on the thread.
    using Maker = std::function<Result<std::unique_ptr<PlayEngine>>(const TaskContext& task)>;
    using Task = std::function<void(PlayEngine&)>;

    explicit PlayThread(QObject* parent = nullptr);
    ~PlayThread() override;

    /// Lets go of what is played, and makes something else.
    void start(Maker maker);
    /// Lets go of what is played.
    void stop();
    /// Has something done; where nothing is played, nothing.
    void post(Task task);
    /// Goes to a moment, the last that is asked for.
    void seek(std::uint64_t step);
    void setPlaying(bool isPlaying);
    void setTimeScale(double scale);

    /// Seconds since some moment.
    double now() const;
    /// Seconds of a step.
    double stepLength() const;
    /// Takes a clock that stands still until advance(): for tests, before anything is played.
    void useSteppedClock();
    /// Moves the stepped clock on, and waits until all that is due is done.
    void advance(double seconds);
    /// Waits until all tasks are done.
    void settle();

    /// What happened since it was taken last.
    PlayNews takeNews();

signals:
    /// There are news; said once until they are taken.
    void hasNews();
    /// What was to be played is there, or could not be made for the reason that is told.
    void started();
    void failed(const QString& sentence);

private:
    void cancelAll();
    void replaceBy(Maker maker);
    void run();
    bool isWorkWaiting() const;
    void work(std::unique_lock<std::mutex>& lock);
    void make(std::unique_lock<std::mutex>& lock);
    void playStep(std::unique_lock<std::mutex>& lock);
    void publish(std::unique_lock<std::mutex>& lock, double shownFor);
    double interval() const;
    double nowLocked() const;

    mutable std::mutex m_mutex;  // guards all below but the engine
    std::condition_variable m_woken;
    std::condition_variable m_idle;
    bool m_isStepped = false;
    double m_steppedNow = 0.0;  // s
    bool m_isQuitting = false;
    bool m_isBusy = false;
    bool m_isPlaying = false;
    bool m_isWanted = false;  // something is played, or about to be
    bool m_hasEngine = false;
    double m_timeScale = 1.0;
    double m_stepLength = 1.0 / 60.0;
    double m_due = 0.0;  // when the next step is due
    Maker m_maker;
    bool m_isStopping = false;
    std::deque<Task> m_tasks;
    std::optional<std::uint64_t> m_seek;
    CancelToken m_cancelMaking;
    CancelToken m_cancelSeek;  // of the way to another moment
    PlayNews m_news;
    bool m_isAnnounced = false;

    std::unique_ptr<PlayEngine> m_engine;  // the thread's own
    std::thread m_thread;
};

}  // namespace rubble
