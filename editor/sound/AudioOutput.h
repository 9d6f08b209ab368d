#pragma once

#include <QObject>

#include <memory>

class QIODevice;

namespace rubble {

/// The default audio device, which plays on a thread of its own. Follows devices that come and go.
class AudioOutput : public QObject {
    Q_OBJECT
public:
    explicit AudioOutput(QObject* parent = nullptr);
    ~AudioOutput() override;

    /// Why there is no sound, as a sentence; empty where there is a device.
    QString fault() const;
    /// Reads 16-bit stereo samples of kSampleRate from a stream, which must live until stop() or the destructor has
    /// returned. Where there is no device, it starts when there is one.
    void start(QIODevice& stream);
    void stop();
    /// Whether it was started, and not stopped since, also where there is no device: no timer runs while it is stopped.
    bool isStarted() const { return m_isStarted; }

signals:
    /// fault() changed.
    void changed();

private:
    struct Devices;
    std::unique_ptr<Devices> m_devices;
    bool m_isStarted = false;
};

}  // namespace rubble
