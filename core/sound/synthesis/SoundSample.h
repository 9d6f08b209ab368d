#pragma once

#include "core/sound/synthesis/SoundMaterial.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rubble {

inline constexpr int kSampleRate = 48000;  // Hz

enum class CueKind : std::uint8_t { Impact, Broken };

/// A mode of a body that rings.
struct SoundMode {
    double frequency = 0.0;  // Hz
    double decay = 0.0;      // s, until the amplitude is 1/e
    double amplitude = 0.0;
};
inline constexpr int kSoundModes = 10;

/// The lowest modes of a loose square plate of a material with this mass, kg > 0, hit for the contact time, s, which
/// excites no frequencies far above its inverse. Those above 18 kHz are inaudible and have no amplitude; none is below
/// 40 Hz.
/// Source: Leissa, "The free vibration of rectangular plates", Journal of Sound and Vibration 31, 1973.
std::array<SoundMode, kSoundModes> modesOf(SoundMaterial material, double mass, double contactTime);

/// What a sound is made of.
struct SoundRecipe {
    CueKind kind = CueKind::Impact;
    SoundMaterial first = SoundMaterial::Concrete;
    SoundMaterial second = SoundMaterial::Concrete;
    double mass = 1.0;             // kg, > 0: of the body
    std::uint64_t randomSeed = 0;  // of noise, and of the cracks of a break
    bool operator==(const SoundRecipe&) const = default;
};

/// A mono sample whose peak is 1: the modes of both materials and the noise of the contact; for a break also a burst of
/// noise and cracks, each of a smaller body. At most 1.5 s long. The same bits everywhere.
std::vector<float> synthesized(const SoundRecipe& recipe);

}  // namespace rubble
