#include "core/sound/mix/SoundTrack.h"

#include "core/base/MessageText.h"
#include "core/sound/mix/Limiter.h"

#include <cmath>

namespace rubble {
namespace {

void addLittleEndian(std::string& bytes, std::uint32_t value, int count) {
    for (int k = 0; k < count; ++k) bytes += static_cast<char>((value >> (8 * k)) & 0xff);
}

}  // namespace

Status checkTrackLength(double seconds) {
    if (seconds >= 0.0 && seconds <= kMaxTrackSeconds) return success();
    return Error{ErrorCode::BadInput,
                 "A sound track is at most " + messageText(kMaxTrackSeconds) + " s long; export a shorter part."};
}

Result<StereoTrack> mixedTrack(std::span<const SoundCue> cues, double seconds, const Listener& listener) {
    if (const Status checked = checkTrackLength(seconds); !checked) return checked.error();
    const auto frames = static_cast<std::size_t>(std::ceil(seconds * kSampleRate));
    StereoSamples mixed(frames, {0.0f, 0.0f});
    SampleCache cache;
    for (std::size_t index = 0; index < cues.size(); ++index) {
        const SoundCue& cue = cues[index];
        if (const std::optional<std::string> fault = faultOf(cue)) {
            return Error{ErrorCode::BadInput, "Sound cue " + std::to_string(index) + " is refused: " + *fault + "."};
        }
        const SharedSample shared = sampleOf(cue, index, cache);
        const std::vector<float>& sample = *shared;
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
        for (const float value : frame) track.samples.push_back(sixteenBits(value));
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
