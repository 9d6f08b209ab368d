#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace rubble {

/// Stereo samples of any amplitude.
using StereoSamples = std::vector<std::array<float, 2>>;

inline constexpr double kCeiling = 0.97;  // of full scale

/// Scales samples so that none exceeds kCeiling: where some do, all within 10 ms are turned down smoothly, both sides
/// alike. Others are left as they are. The samples come out kDelay later than they go in. O(1) each.
class Limiter {
public:
    static constexpr std::int64_t kWindow = 480;         // samples to each side: 10 ms
    static constexpr std::int64_t kDelay = 2 * kWindow;  // samples: 20 ms

    /// Takes samples, and appends those that come out. The same samples, in parts of any length, give the same bits.
    void add(std::span<const std::array<float, 2>> samples, StereoSamples& out);
    /// Appends the last samples. Nothing can be added then.
    void finish(StereoSamples& out);

private:
    struct Gain {
        std::int64_t sample = 0;
        double value = 1.0;
    };
    void addLeast(std::int64_t sample, double least, StereoSamples& out);
    void release(std::int64_t sample, std::int64_t last, StereoSamples& out);

    std::int64_t m_count = 0;                    // samples that were added
    std::deque<std::array<float, 2>> m_waiting;  // those that have not come out
    std::deque<Gain> m_candidates;               // for the least gain of the window: ascending
    std::deque<double> m_least;                  // of the window around each sample of the window
    double m_missing = 0.0;                      // sum of 1 - m_least: exactly 0 where nothing is turned down
    std::int64_t m_turnedDown = 0;               // those of m_least that are below 1
};

/// The samples as a Limiter gives them, without its delay.
void limit(StereoSamples& samples);

/// A limited sample as 16 bits.
std::int16_t sixteenBits(float value);

}  // namespace rubble
