#include "editor/sound/SoundStreamDevice.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace rubble {

namespace {

constexpr qint64 kFrameBytes = 4;     // two sides of 16 bits
constexpr qint64 kBlockFrames = 480;  // 10 ms

}  // namespace

/// Without a buffer, which would be heard as a delay.
SoundStreamDevice::SoundStreamDevice(QObject* parent) : QIODevice(parent) { open(ReadOnly | Unbuffered); }

void SoundStreamDevice::add(SoundCue cue, SharedSample sample) {
    bool wasQuiet = false;
    {
        const std::lock_guard lock(m_mutex);
        cue.time += static_cast<double>(m_stream.position()) / kSampleRate;
        m_stream.add(cue, m_listener, std::move(sample));
        wasQuiet = std::exchange(m_quietFrames, 0) == kQuietFrames;
    }
    if (wasQuiet) emit quietChanged();
}

bool SoundStreamDevice::isQuiet() const {
    const std::lock_guard lock(m_mutex);
    return m_quietFrames == kQuietFrames;
}

/// Counts frames that were read; returns whether it has become quiet with them.
bool SoundStreamDevice::advanceQuiet(std::uint64_t frames) {
    const std::uint64_t before =
        std::exchange(m_quietFrames, m_stream.isSilent() ? std::min(m_quietFrames + frames, kQuietFrames) : 0);
    return before < kQuietFrames && m_quietFrames == kQuietFrames;
}

void SoundStreamDevice::setListener(const Listener& listener) {
    const std::lock_guard lock(m_mutex);
    m_listener = listener;
}

void SoundStreamDevice::silence() {
    const std::lock_guard lock(m_mutex);
    m_stream.silence();
}

void SoundStreamDevice::setVolume(double volume) {
    const std::lock_guard lock(m_mutex);
    m_stream.setVolume(volume);
}

/// It never ends.
qint64 SoundStreamDevice::bytesAvailable() const { return kSampleRate * kFrameBytes + QIODevice::bytesAvailable(); }

qint64 SoundStreamDevice::readData(char* data, qint64 most) {
    std::array<std::int16_t, 2 * kBlockFrames> block;
    const qint64 frames = most / kFrameBytes;
    for (qint64 done = 0; done < frames;) {
        const qint64 count = std::min(kBlockFrames, frames - done);
        bool isQuietNow = false;
        {
            const std::lock_guard lock(m_mutex);
            m_stream.mix(std::span(block).first(static_cast<std::size_t>(2 * count)));
            isQuietNow = advanceQuiet(static_cast<std::uint64_t>(count));
        }
        if (isQuietNow) emit quietChanged();
        std::memcpy(data + done * kFrameBytes, block.data(), static_cast<std::size_t>(count * kFrameBytes));
        done += count;
    }
    return frames * kFrameBytes;
}

qint64 SoundStreamDevice::writeData(const char*, qint64) { return -1; }

}  // namespace rubble

#include "moc_SoundStreamDevice.cpp"
