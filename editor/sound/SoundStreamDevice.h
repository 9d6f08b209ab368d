#pragma once

#include "core/sound/mix/SoundStream.h"

#include <QIODevice>

#include <mutex>

namespace rubble {

/// A SoundStream as an audio device reads it: from another thread than those that add to it. Each call takes a lock for
/// as long as 10 ms of sound take to be mixed, at most.
class SoundStreamDevice : public QIODevice {
    Q_OBJECT
public:
    explicit SoundStreamDevice(QObject* parent = nullptr);

    /// Adds a cue that is valid, whose time counts from now.
    void add(SoundCue cue, SharedSample sample);
    void setListener(const Listener& listener);
    /// See SoundStream.
    void silence();
    void setVolume(double volume);
    /// Whether nothing has sounded for a second of what was read, and nothing waits to. So it is at first.
    bool isQuiet() const;

    bool isSequential() const override { return true; }
    qint64 bytesAvailable() const override;

signals:
    /// isQuiet() changed; emitted on the thread that reads, or adds.
    void quietChanged();

protected:
    qint64 readData(char* data, qint64 most) override;
    qint64 writeData(const char* data, qint64 size) override;

private:
    static constexpr std::uint64_t kQuietFrames = kSampleRate;

    bool advanceQuiet(std::uint64_t frames);

    mutable std::mutex m_mutex;  // guards all below
    SoundStream m_stream;
    Listener m_listener;
    std::uint64_t m_quietFrames = kQuietFrames;  // that were read since something sounded, up to kQuietFrames
};

}  // namespace rubble
