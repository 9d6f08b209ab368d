#pragma once

#include "core/sound/mix/Limiter.h"
#include "core/sound/mix/SoundCue.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Mixes cues to an endless stereo stream of 16 bits at kSampleRate, while they come: what mixedTrack() gives,
/// Limiter::kDelay later. At most kMaxVoices sound at a time, the loudest. Not thread-safe.
class SoundStream {
public:
    SoundStream();

    static constexpr std::size_t kMaxVoices = 128;

    /// Adds a cue that is valid, with its sample. It sounds at its time in the stream, or at once where that is over.
    void add(const SoundCue& cue, const Listener& listener, SharedSample sample);
    /// Fills the next samples: left, right, left, ...
    void mix(std::span<std::int16_t> samples);
    /// Fades what sounds out within 10 ms, and drops what waits.
    void silence();
    /// The gain of the following samples, >= 0; 1 at first. It changes within 10 ms.
    void setVolume(double volume) { m_targetVolume = static_cast<float>(volume); }
    /// The samples of a side that were mixed so far.
    std::uint64_t position() const { return m_position; }
    bool isSilent() const { return m_voices.empty(); }

private:
    struct Voice {
        SharedSample sample;
        std::uint64_t start = 0;  // in the stream
        std::array<double, 2> levels{};
        std::uint64_t fadesAt = kNever;  // in the stream
        static constexpr std::uint64_t kNever = ~std::uint64_t{0};
    };
    void mixVoice(const Voice& voice);
    void applyVolume();

    std::vector<Voice> m_voices;  // in the order in which they were added
    std::uint64_t m_position = 0;
    float m_volume = 1.0f, m_targetVolume = 1.0f;
    Limiter m_limiter;
    StereoSamples m_mixed;    // of a call, kept for its memory; as is the next
    StereoSamples m_limited;  // that come out
};

}  // namespace rubble
