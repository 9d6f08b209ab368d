#include "core/sound/mix/Limiter.h"

#include <algorithm>
#include <cmath>

namespace rubble {

void Limiter::add(std::span<const std::array<float, 2>> samples, StereoSamples& out) {
    for (const std::array<float, 2>& sample : samples) {
        const double peak = std::max(std::abs(sample[0]), std::abs(sample[1]));
        const double gain = peak > kCeiling ? kCeiling / peak : 1.0;
        while (!m_candidates.empty() && m_candidates.back().value >= gain) m_candidates.pop_back();
        m_candidates.push_back({m_count, gain});
        m_waiting.push_back(sample);
        const std::int64_t around = m_count++ - kWindow;
        if (m_candidates.front().sample < around - kWindow) m_candidates.pop_front();
        if (around >= 0) addLeast(around, m_candidates.front().value, out);
    }
}

void Limiter::finish(StereoSamples& out) {
    for (std::int64_t around = std::max<std::int64_t>(m_count - kWindow, 0); around < m_count; ++around) {
        while (m_candidates.front().sample < around - kWindow) m_candidates.pop_front();
        addLeast(around, m_candidates.front().value, out);
    }
    const std::int64_t first = m_count - static_cast<std::int64_t>(m_waiting.size());
    for (std::int64_t sample = first; sample < m_count; ++sample) release(sample, m_count - 1, out);
}

/// Takes the least gain of the window around a sample; the one a window before can come out then.
void Limiter::addLeast(std::int64_t sample, double least, StereoSamples& out) {
    m_least.push_back(least);
    if (least < 1.0) m_missing += 1.0 - least, ++m_turnedDown;
    if (sample >= kWindow) release(sample - kWindow, sample, out);
}

/// Appends the first waiting sample. `last`: the last one of its window.
void Limiter::release(std::int64_t sample, std::int64_t last, StereoSamples& out) {
    // The mean of what is at most the gain of a sample at every place of the window is at most that gain.
    const std::int64_t first = std::max<std::int64_t>(sample - kWindow, 0);
    while (static_cast<std::int64_t>(m_least.size()) > last - first + 1) {
        if (m_least.front() < 1.0) m_missing -= 1.0 - m_least.front(), --m_turnedDown;
        m_least.pop_front();
    }
    std::array<float, 2> released = m_waiting.front();
    m_waiting.pop_front();
    if (m_turnedDown == 0) m_missing = 0.0;
    if (m_turnedDown > 0) {
        const auto gain = static_cast<float>(1.0 - m_missing / static_cast<double>(last - first + 1));
        for (float& side : released) side *= gain;
    }
    out.push_back(released);
}

void limit(StereoSamples& samples) {
    Limiter limiter;
    StereoSamples limited;
    limited.reserve(samples.size());
    limiter.add(samples, limited);
    limiter.finish(limited);
    samples = std::move(limited);
}

std::int16_t sixteenBits(float value) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0f, 1.0f) * 32767.0f));
}

}  // namespace rubble
