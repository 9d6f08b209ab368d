#pragma once

#include "core/base/Result.h"
#include "core/sound/mix/SoundCue.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// Stereo, 16 bit, kSampleRate.
struct StereoTrack {
    std::vector<std::int16_t> samples;  // left, right, left, ...
    std::size_t frames() const { return samples.size() / 2; }
};

/// Errors: BadInput for a length, s, beyond kMaxTrackSeconds.
Status checkTrackLength(double seconds);

/// Mixes cues to a track of this length. A sound begins at its cue's time, whatever its distance; see levelsOf(). A
/// limiter keeps the track below full scale. The same cues give the same bits everywhere.
///
/// Errors: BadInput for a length beyond kMaxTrackSeconds, or a cue that is not finite or out of range, with its index.
Result<StereoTrack> mixedTrack(std::span<const SoundCue> cues, double seconds, const Listener& listener);

/// The track as a WAV file: RIFF, PCM.
std::string wavFile(const StereoTrack& track);

}  // namespace rubble
