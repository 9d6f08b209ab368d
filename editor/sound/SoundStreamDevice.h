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

    bool isSequential() const override { return true; }
    qint64 bytesAvailable() const override;

protected:
    qint64 readData(char* data, qint64 most) override;
    qint64 writeData(const char* data, qint64 size) override;

private:
    std::mutex m_mutex;  // guards all below
    SoundStream m_stream;
    Listener m_listener;
};

}  // namespace rubble
