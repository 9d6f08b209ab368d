#pragma once

#include "core/sound/mix/SoundCue.h"
#include "editor/play/ForecastThread.h"
#include "editor/play/PlayEngine.h"

#include <QObject>

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace rubble {

/// How long the motion of a step is shown, s: for as long as it took to compute, within limits, and for an interval at
/// least.
double shownDuration(double computed, double interval);

/// Runs a PlayEngine on a thread, one step every `dt / timeScale` seconds of a clock, and pauses at the end of a
/// script. Slow steps make play fall behind; it does not catch up. While the engine is at rest no step is played: the
/// time of the simulation stands still until the next task. Tasks and seeks run between steps, in order,
/// asynchronously. The engine's forecasts are computed beside it.
class PlayThread : public QObject {
    Q_OBJECT
public:
    /// Creates the engine; called on the thread.
    using EngineFactory = std::function<Result<std::unique_ptr<PlayEngine>>(const TaskContext& task)>;
    using Task = std::function<void(PlayEngine&)>;

    explicit PlayThread(QObject* parent = nullptr);
    ~PlayThread() override;

    /// Replaces the engine.
    void start(EngineFactory factory);
    /// Destroys the engine.
    void stop();
    /// Whether there is an engine, or one is being created.
    bool isStarted() const;
    /// Queues a task; ignored without an engine.
    void post(Task task);
    /// Seeks to a step, after the tasks that were queued before; replaces a seek that no later task waits for. Where
    /// the step was played before, or one before it, an update with its recorded frame is available at once, and the
    /// one of the session follows.
    void seek(std::uint64_t step);
    void setPlaying(bool isPlaying);
    void setTimeScale(double scale);

    /// The time of the clock, s.
    double now() const;
    /// The simulated duration of a step, s.
    double stepLength() const;
    /// Uses a clock that moves only by advance(): for tests, before start().
    void useSteppedClock();
    /// Advances the stepped clock and waits until all due work is done.
    void advance(double seconds);
    /// Waits until all tasks are done.
    void settle();

    /// Returns and clears the pending update.
    PlayUpdate takeUpdate();

signals:
    /// An update is available; emitted once until it is taken.
    void updateReady();
    /// The engine was created, or could not be, for the given reason.
    void started();
    void failed(const QString& sentence);
    /// What is heard of a step that was played, not sought; its picture is complete `shownAfter` seconds later. Emitted
    /// on the thread, which waits for what is connected directly.
    void cuesPlayed(const std::vector<rubble::SoundCue>& cues, double shownAfter);

private:
    void cancelAll();
    void failLater(const Error& error);
    void restartWith(EngineFactory factory);
    void run();
    bool isWorkWaiting() const;
    void work(std::unique_lock<std::mutex>& lock);
    void runTasks(std::unique_lock<std::mutex>& lock);
    void runSeek(std::unique_lock<std::mutex>& lock);
    bool isSeekWaiting() const;
    void stopAfter(const Error& error);
    void createEngine(std::unique_lock<std::mutex>& lock);
    void playStep(std::unique_lock<std::mutex>& lock);
    void publish(std::unique_lock<std::mutex>& lock, double shownFor);
    double interval() const;
    double nowLocked() const;

    mutable std::mutex m_mutex;  // guards all members below but the engine
    std::condition_variable m_wake;
    std::condition_variable m_idle;
    bool m_isStepped = false;
    double m_steppedNow = 0.0;  // s
    bool m_isQuitting = false;
    bool m_isBusy = false;
    bool m_isPlaying = false;
    bool m_isResting = false;  // the engine is at rest
    bool m_isStarted = false;  // there is an engine, or one is being created
    bool m_hasEngine = false;
    double m_timeScale = 1.0;
    double m_stepLength = 1.0 / 60.0;
    double m_due = 0.0;  // when the next step is due
    EngineFactory m_factory;
    bool m_isStopping = false;
    /// A task, or a seek if it has a step.
    struct Work {
        Task task;
        std::optional<std::uint64_t> step;
    };
    std::deque<Work> m_work;
    std::shared_ptr<const RecordedFrames> m_recorded;  // of the engine
    bool m_isRecordedShown = false;                    // the update has the recorded frame of the last seek, or had
    CancelToken m_cancelStart;
    CancelToken m_cancelSeek;
    PlayUpdate m_update;
    bool m_isUpdateSignalled = false;

    ForecastThread m_forecasts;
    std::unique_ptr<PlayEngine> m_engine;  // used on the thread only
    std::jthread m_thread;                 // started with the first engine
};

}  // namespace rubble
