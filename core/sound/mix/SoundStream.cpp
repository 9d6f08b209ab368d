#include "core/sound/mix/SoundStream.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr std::uint64_t kFadeOut = 480;  // samples: 10 ms

double loudness(const std::array<double, 2>& levels) { return levels[0] + levels[1]; }

}  // namespace

SoundStream::SoundStream() : m_limited(Limiter::kDelay, {0.0f, 0.0f}) {}

void SoundStream::add(const SoundCue& cue, const Listener& listener, SharedSample sample) {
    Voice added{.sample = std::move(sample), .levels = levelsOf(cue, listener)};
    added.start = std::max(m_position, static_cast<std::uint64_t>(std::llround(cue.time * kSampleRate)));
    if (m_voices.size() == kMaxVoices) {
        const auto quieter = [](const Voice& a, const Voice& b) { return loudness(a.levels) < loudness(b.levels); };
        const auto quietest = std::ranges::min_element(m_voices, quieter);
        if (!quieter(*quietest, added)) return;
        m_voices.erase(quietest);
    }
    m_voices.push_back(std::move(added));
}

void SoundStream::silence() {
    std::erase_if(m_voices, [this](const Voice& voice) { return voice.start >= m_position; });
    for (Voice& voice : m_voices) voice.fadesAt = std::min(voice.fadesAt, m_position);
}

/// Adds what sounds of a voice in these samples.
void SoundStream::mixVoice(const Voice& voice) {
    const std::uint64_t end = m_position + m_mixed.size();
    const std::uint64_t last = std::min(
        {end, voice.start + voice.sample->size(), voice.fadesAt == Voice::kNever ? end : voice.fadesAt + kFadeOut});
    for (std::uint64_t at = std::max(m_position, voice.start); at < last; ++at) {
        double value = (*voice.sample)[at - voice.start];
        if (voice.fadesAt != Voice::kNever) value *= 1.0 - static_cast<double>(at - voice.fadesAt) / kFadeOut;
        std::array<float, 2>& mixed = m_mixed[at - m_position];
        mixed[0] += static_cast<float>(voice.levels[0] * value);
        mixed[1] += static_cast<float>(voice.levels[1] * value);
    }
}

void SoundStream::applyVolume() {
    if (m_volume == 1.0f && m_targetVolume == 1.0f) return;
    constexpr float kChange = 1.0f / kFadeOut;
    for (std::array<float, 2>& sample : m_mixed) {
        m_volume += std::clamp(m_targetVolume - m_volume, -kChange, kChange);
        for (float& side : sample) side *= m_volume;
    }
}

void SoundStream::mix(std::span<std::int16_t> samples) {
    const std::size_t count = samples.size() / 2;
    m_mixed.assign(count, {0.0f, 0.0f});
    for (const Voice& voice : m_voices) mixVoice(voice);
    applyVolume();
    m_position += count;
    std::erase_if(m_voices, [this](const Voice& voice) {
        const bool hasFaded = voice.fadesAt != Voice::kNever && voice.fadesAt + kFadeOut <= m_position;
        return hasFaded || voice.start + voice.sample->size() <= m_position;
    });
    m_limiter.add(m_mixed, m_limited);
    for (std::size_t k = 0; k < count; ++k) {
        samples[2 * k] = sixteenBits(m_limited[k][0]);
        samples[2 * k + 1] = sixteenBits(m_limited[k][1]);
    }
    m_limited.erase(m_limited.begin(), m_limited.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace rubble
