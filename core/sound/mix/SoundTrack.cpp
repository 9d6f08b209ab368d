#include "core/sound/mix/SoundTrack.h"

#include "core/base/MessageText.h"
#include "core/base/Random.h"
#include "core/base/math/Trigonometry.h"
#include "core/sound/mix/Limiter.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace rubble {
namespace {

constexpr double kAmplitudeOfJoule = 0.02;           // of full scale, 1 m away: 2.5 kJ reach it
constexpr double kNearest = 1.0;                     // m: what is nearer is as loud
constexpr std::uint64_t kTakes = 4;                  // samples of the same kind that follow each other
constexpr double kLightest = 1e-3, kHeaviest = 1e5;  // kg: bodies beyond sound like these

bool isFinite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::optional<std::string> faultOf(const SoundCue& cue) {
    if (!(cue.time >= 0.0 && cue.time <= kMaxTrackSeconds)) return "its time is not within the longest track";
    if (!(cue.energy >= 0.0 && std::isfinite(cue.energy))) return "its energy is negative or not finite";
    if (!(cue.mass > 0.0 && std::isfinite(cue.mass))) return "its mass is not positive and finite";
    if (!isFinite(cue.point)) return "its point is not finite";
    return std::nullopt;
}

/// Samples that were made. Masses between the same two powers of two sound alike.
class SampleCache {
public:
    const std::vector<float>& sampleOf(const SoundCue& cue, std::uint64_t take) {
        int size = 0;
        std::frexp(std::clamp(cue.mass, kLightest, kHeaviest), &size);
        const auto key = std::tuple(cue.kind, cue.first, cue.second, size, take);
        const auto found = m_samples.find(key);
        if (found != m_samples.end()) return found->second;
        std::uint64_t seed = mixSeeds(static_cast<std::uint64_t>(cue.kind), take);
        seed = mixSeeds(
            seed, static_cast<std::uint64_t>(cue.first) * kSoundMaterials + static_cast<std::uint64_t>(cue.second));
        seed = mixSeeds(seed, static_cast<std::uint64_t>(size + 1000));
        return m_samples[key] = synthesized({.kind = cue.kind,
                                             .first = cue.first,
                                             .second = cue.second,
                                             .mass = std::ldexp(0.75, size),
                                             .randomSeed = seed});
    }

private:
    std::map<std::tuple<CueKind, SoundMaterial, SoundMaterial, int, std::uint64_t>, std::vector<float>> m_samples;
};

/// The amplitudes of a cue on the left and on the right.
std::array<double, 2> levelsOf(const SoundCue& cue, const Listener& listener) {
    const Vec3 way = cue.point - listener.position;
    const double distance = glm::length(way);
    const double level = kAmplitudeOfJoule * std::sqrt(cue.energy) / std::max(kNearest, distance);
    const double pan = distance > 0.0 ? std::clamp(glm::dot(way, listener.right) / distance, -1.0, 1.0) : 0.0;
    const double angle = (1.0 + pan) * kFullTurn / 8.0;
    return {level * cosine(angle), level * sine(angle)};
}

void addLittleEndian(std::string& bytes, std::uint32_t value, int count) {
    for (int k = 0; k < count; ++k) bytes += static_cast<char>((value >> (8 * k)) & 0xff);
}

}  // namespace

Result<StereoTrack> mixedTrack(std::span<const SoundCue> cues, double seconds, const Listener& listener) {
    if (!(seconds >= 0.0 && seconds <= kMaxTrackSeconds)) {
        return Error{ErrorCode::BadInput,
                     "A sound track is at most " + messageText(kMaxTrackSeconds) + " s long; export a shorter part."};
    }
    const auto frames = static_cast<std::size_t>(std::ceil(seconds * kSampleRate));
    StereoSamples mixed(frames, {0.0f, 0.0f});
    SampleCache cache;
    for (std::size_t index = 0; index < cues.size(); ++index) {
        const SoundCue& cue = cues[index];
        if (const std::optional<std::string> fault = faultOf(cue)) {
            return Error{ErrorCode::BadInput, "Sound cue " + std::to_string(index) + " is refused: " + *fault + "."};
        }
        const std::vector<float>& sample = cache.sampleOf(cue, index % kTakes);
        const std::array<double, 2> levels = levelsOf(cue, listener);
        const auto start = static_cast<std::size_t>(std::lround(cue.time * kSampleRate));
        for (std::size_t k = 0; k < sample.size() && start + k < frames; ++k) {
            mixed[start + k][0] += static_cast<float>(levels[0] * sample[k]);
            mixed[start + k][1] += static_cast<float>(levels[1] * sample[k]);
        }
    }
    limit(mixed);
    StereoTrack track;
    track.samples.reserve(2 * frames);
    for (const std::array<float, 2>& frame : mixed) {
        for (const float value : frame) {
            track.samples.push_back(static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0f, 1.0f) * 32767.0f)));
        }
    }
    return track;
}

std::string wavFile(const StereoTrack& track) {
    constexpr std::uint32_t kFrameBytes = 4, kFormatBytes = 16, kHeaderBytes = 36;
    const auto bytes = static_cast<std::uint32_t>(track.frames() * kFrameBytes);
    std::string file = "RIFF";
    addLittleEndian(file, kHeaderBytes + bytes, 4);
    file += "WAVEfmt ";
    addLittleEndian(file, kFormatBytes, 4);
    addLittleEndian(file, 1, 2);  // PCM
    addLittleEndian(file, 2, 2);  // channels
    addLittleEndian(file, kSampleRate, 4);
    addLittleEndian(file, kSampleRate * kFrameBytes, 4);
    addLittleEndian(file, kFrameBytes, 2);
    addLittleEndian(file, 16, 2);  // bits
    file += "data";
    addLittleEndian(file, bytes, 4);
    for (const std::int16_t sample : track.samples) addLittleEndian(file, static_cast<std::uint16_t>(sample), 2);
    return file;
}

}  // namespace rubble
