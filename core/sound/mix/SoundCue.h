#pragma once

#include "core/geometry/predicates/Vec.h"
#include "core/sound/synthesis/SampleCache.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

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

/// Where cues are heard.
struct Listener {
    Vec3 position{0.0, 0.0, 0.0};  // m
    Vec3 right{1.0, 0.0, 0.0};     // length 1
};

inline constexpr double kMaxTrackSeconds = 3600.0;

/// What is wrong with a cue, as part of a sentence, if anything: "its energy is negative or not finite".
std::optional<std::string> faultOf(const SoundCue& cue);

/// The amplitudes of a cue on the left and on the right: in proportion to the square root of the energy, and to the
/// inverse of the distance beyond 1 m; panned with constant power.
std::array<double, 2> levelsOf(const SoundCue& cue, const Listener& listener);

/// The sample of a cue. Cues of a kind that follow each other sound a little differently, by their index among all.
SharedSample sampleOf(const SoundCue& cue, std::uint64_t index, SampleCache& cache);

}  // namespace rubble
