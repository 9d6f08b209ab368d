#pragma once

#include "editor/sound/AudioOutput.h"
#include "editor/sound/SoundStreamDevice.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <thread>

namespace rubble {

/// When the audio device runs. A running device wakes a hundred times a second.
enum class OutputUse {
    Never,
    WhileHeard,  // from a cue until a second of silence has passed; the first cue then is heard a little later
    Always
};

/// Plays cues while they come, on the default audio device. Samples are made on a thread of their own: who plays a cue
/// waits for nothing but a lock that is never held for long. Without threads to start there is no sound.
class SoundPlayer : public QObject {
    Q_OBJECT
public:
    explicit SoundPlayer(QObject* parent = nullptr);
    ~SoundPlayer() override;

    AudioOutput& output() { return m_output; }
    /// What the device reads.
    SoundStreamDevice& stream() { return m_stream; }
    /// Sets when the audio device runs: never at first.
    void setOutputUse(OutputUse use);
    /// Whether cues are played; they are not at first. Those that sound fade out within 10 ms when it ends.
    void setHearing(bool isHearing);
    void setListener(const Listener& listener) { m_stream.setListener(listener); }
    /// The gain, in [0, 1].
    void setVolume(double volume) { m_stream.setVolume(volume); }

    /// Plays valid cues together, `after` seconds from now. From any thread. Of those that wait for their samples, more
    /// than kMaxWaiting are dropped, the oldest first.
    void play(const std::vector<SoundCue>& cues, double after);
    /// Waits until no cue waits for its sample.
    void finishSamples();

    static constexpr std::size_t kMaxWaiting = 64;

private:
    using Clock = std::chrono::steady_clock;
    struct Waiting {
        SoundCue cue;
        Clock::time_point due;
    };
    void run();
    void updateOutput();

    OutputUse m_use = OutputUse::Never;
    SoundStreamDevice m_stream;
    std::mutex m_mutex;  // guards what follows, up to the cache
    std::condition_variable m_wake, m_idle;
    std::deque<Waiting> m_waiting;
    bool m_isHearing = false;
    bool m_isBusy = false;
    bool m_isQuitting = false;
    SampleCache m_cache;        // of the thread
    std::uint64_t m_count = 0;  // of the thread: cues so far
    AudioOutput m_output;       // reads the stream
    std::jthread m_thread;      // started with the first cues
};

}  // namespace rubble
