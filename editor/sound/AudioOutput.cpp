#include "editor/sound/AudioOutput.h"

#if RUBBLE_HAS_MULTIMEDIA

#include "core/sound/synthesis/SoundSample.h"

#include <QAudioDevice>
#include <QAudioSink>
#include <QMediaDevices>
#include <QThread>
#include <QTimer>

#include <functional>
#include <utility>

namespace rubble {

namespace {

constexpr int kBufferBytes = kSampleRate * 4 * 8 / 100;  // 80 ms, of which the server keeps a part
constexpr int kInterval = 10;                            // ms, between two looks at what the buffer has room for

QAudioFormat format() {
    QAudioFormat format;
    format.setSampleRate(kSampleRate);
    format.setChannelCount(2);
    format.setSampleFormat(QAudioFormat::Int16);
    return format;
}

/// Fills a device's buffer from a stream. In Qt 6.4 a sink that reads by itself takes parts of 20 ms only, with which a
/// short buffer is never full enough to start.
class Feeder : public QObject {
public:
    Feeder(const QAudioDevice& device, QIODevice& stream) : m_sink(device, format()), m_stream(stream) {
        m_sink.setBufferSize(kBufferBytes);
        m_device = m_sink.start();
        m_timer.setTimerType(Qt::PreciseTimer);
        connect(&m_timer, &QTimer::timeout, this, &Feeder::fill);
        m_timer.start(kInterval);
        fill();
    }
    bool hasFailed() const {
        return m_device == nullptr || m_sink.state() == QAudio::StoppedState ||
               (m_sink.error() != QAudio::NoError && m_sink.error() != QAudio::UnderrunError);
    }
    std::function<void()> failed;  // is called when the device no longer plays

private:
    void fill() {
        if (hasFailed()) {
            m_timer.stop();
            if (failed) failed();
            return;
        }
        const qint64 room = m_sink.bytesFree();
        if (room > m_waiting.size()) m_waiting += m_stream.read(room - m_waiting.size());
        const qint64 written = m_device->write(m_waiting);
        if (written > 0) m_waiting.remove(0, written);
    }

    QAudioSink m_sink;
    QIODevice& m_stream;
    QIODevice* m_device = nullptr;
    QByteArray m_waiting;  // what the device did not take
    QTimer m_timer;
};

}  // namespace

/// What runs on the thread is called through `host`, which lives there.
struct AudioOutput::Devices {
    QMediaDevices watch;
    QThread thread;
    QObject host;
    std::unique_ptr<Feeder> feeder;  // of the thread
    QIODevice* stream = nullptr;     // null: stopped
    bool isReading = false;
    bool hasFailed = false;  // until the devices change
    int started = 0;         // how often: what a former sink still says does not count

    ~Devices() {
        if (!thread.isRunning()) return;
        thread.quit();
        thread.wait();
    }

    void read(AudioOutput& output) {
        const QAudioDevice device = QMediaDevices::defaultAudioOutput();
        if (stream == nullptr || isReading || hasFailed || device.isNull()) return;
        isReading = true;
        ++started;
        if (!thread.isRunning()) {
            host.moveToThread(&thread);
            thread.start(QThread::TimeCriticalPriority);
        }
        QMetaObject::invokeMethod(&host, [this, &output, device, source = stream, which = started] {
            feeder = std::make_unique<Feeder>(device, *source);
            const auto fail = [this, &output, which] {
                QMetaObject::invokeMethod(
                    &output, [this, &output, which] { endFailed(output, which); }, Qt::QueuedConnection);
            };
            feeder->failed = fail;
            if (feeder->hasFailed()) fail();
        });
    }

    /// The device has stopped by itself.
    void endFailed(AudioOutput& output, int which) {
        if (!isReading || which != started) return;
        hasFailed = true;
        end();
        emit output.changed();
    }

    void end() {
        if (!std::exchange(isReading, false)) return;
        QMetaObject::invokeMethod(
            &host, [this] { feeder.reset(); }, Qt::BlockingQueuedConnection);
    }
};

AudioOutput::AudioOutput(QObject* parent) : QObject(parent), m_devices(std::make_unique<Devices>()) {
    connect(&m_devices->watch, &QMediaDevices::audioOutputsChanged, this, [this] {
        m_devices->end();  // another may be the default
        m_devices->hasFailed = false;
        m_devices->read(*this);
        emit changed();
    });
}

AudioOutput::~AudioOutput() { stop(); }

QString AudioOutput::fault() const {
    if (m_devices->hasFailed) return tr("The audio device does not answer. Connect it again, or another one.");
    if (!QMediaDevices::defaultAudioOutput().isNull()) return {};
    return tr("There is no audio device. Connect one, or start the sound server.");
}

void AudioOutput::start(QIODevice& stream) {
    m_isStarted = true;
    m_devices->stream = &stream;
    m_devices->read(*this);
}

void AudioOutput::stop() {
    m_isStarted = false;
    m_devices->stream = nullptr;
    m_devices->end();
}

}  // namespace rubble

#else

namespace rubble {

struct AudioOutput::Devices {};

AudioOutput::AudioOutput(QObject* parent) : QObject(parent) {}
AudioOutput::~AudioOutput() = default;
QString AudioOutput::fault() const {
    return tr("This program was built without sound. Build it with Qt Multimedia installed.");
}
void AudioOutput::start(QIODevice&) { m_isStarted = true; }
void AudioOutput::stop() { m_isStarted = false; }

}  // namespace rubble

#endif

#include "moc_AudioOutput.cpp"
