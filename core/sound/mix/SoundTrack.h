#pragma once

#include "core/base/Result.h"
#include "core/geometry/predicates/Vec.h"
#include "core/sound/synthesis/SoundSample.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// Something that sounds.
struct SoundCue {
    double time = 0.0;  // s, >= 0
    CueKind kind = CueKind::Impact;
    SoundMaterial first = SoundMaterial::Concrete;  // of the body
    SoundMaterial second = SoundMaterial::Concrete;
    double energy = 0.0;        // J, >= 0
    double mass = 1.0;          // kg, > 0: of the body
    Vec3 point{0.0, 0.0, 0.0};  // m
};

/// Where a track is heard.
struct Listener {
    Vec3 position{0.0, 0.0, 0.0};  // m
    Vec3 right{1.0, 0.0, 0.0};     // length 1
};

/// Stereo, 16 bit, kSampleRate.
struct StereoTrack {
    std::vector<std::int16_t> samples;  // left, right, left, ...
    std::size_t frames() const { return samples.size() / 2; }
};

inline constexpr double kMaxTrackSeconds = 3600.0;

/// Mixes cues to a track of this length. A sound begins at its cue's time, whatever its distance; its amplitude grows
/// with the square root of the energy, and falls with the distance beyond 1 m. It is panned with constant power. A
/// limiter, which looks 10 ms ahead, keeps the track below full scale. The same cues give the same bits everywhere.
///
/// Errors: BadInput for a length beyond kMaxTrackSeconds, or a cue that is not finite or out of range, with its index.
Result<StereoTrack> mixedTrack(std::span<const SoundCue> cues, double seconds, const Listener& listener);

/// The track as a WAV file: RIFF, PCM.
std::string wavFile(const StereoTrack& track);

}  // namespace rubble
