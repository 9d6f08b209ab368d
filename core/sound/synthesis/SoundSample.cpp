#include "core/sound/synthesis/SoundSample.h"

#include "core/base/Random.h"
#include "core/base/math/Power.h"
#include "core/base/math/Roots.h"
#include "core/base/math/Trigonometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble {
namespace {

constexpr double kLowest = 40.0, kHighest = 18000.0;  // Hz
constexpr double kLongest = 1.5;                      // s
constexpr double kInaudible = 1e-3;                   // of the peak: 60 dB below
constexpr double kAudibleDecays = 7.0;                // e^-7 is inaudible
constexpr double kE = std::numbers::e;

/// A sum of sounds while it is made.
using Buffer = std::vector<double>;

std::size_t samplesOf(double seconds) { return static_cast<std::size_t>(seconds * kSampleRate); }

/// Adds a decaying sine, which starts at 0. A two-pole resonator makes it with two multiplications a sample.
void addMode(Buffer& buffer, std::size_t start, const SoundMode& mode) {
    const double angle = kFullTurn * mode.frequency / kSampleRate;
    const double radius = power(kE, -1.0 / (mode.decay * kSampleRate));
    const double feedback = 2.0 * radius * cosine(angle), loss = radius * radius;
    double before = 0.0, now = mode.amplitude * radius * sine(angle);
    const std::size_t end = std::min(buffer.size(), start + samplesOf(kAudibleDecays * mode.decay));
    for (std::size_t k = start; k < end; ++k) {
        buffer[k] += now;
        const double next = feedback * now - loss * before;
        before = now;
        now = next;
    }
}

/// Adds decaying noise. `brightness` in (0, 1] is the weight of each new sample in both low passes.
void addNoise(Buffer& buffer, std::size_t start, double decay, double brightness, double amplitude, Random& random) {
    const double radius = power(kE, -1.0 / (decay * kSampleRate));
    double first = 0.0, second = 0.0;
    double level = amplitude * std::sqrt((2.0 - brightness) / brightness);  // the low passes take the rest
    const std::size_t end = std::min(buffer.size(), start + samplesOf(kAudibleDecays * decay));
    for (std::size_t k = start; k < end; ++k) {
        const double white = random.between(-1.0, 1.0);
        first = k == start ? white : first + brightness * (white - first);
        second += brightness * (first - second);
        buffer[k] += level * second;
        level *= radius;
    }
}

/// Adds a blow: a click as long as the contact, and the modes of both bodies.
void addBlow(Buffer& buffer, std::size_t start, const SoundRecipe& recipe, double mass, double amplitude,
             Random& random) {
    const SoundProperties &first = propertiesOf(recipe.first), &second = propertiesOf(recipe.second);
    // Of a sphere that hits a plane, by Hertz: Johnson, "Contact Mechanics", 1985, equation 11.24.
    const double contactTime =
        std::clamp(std::max(first.contactTime, second.contactTime) * power(mass, 0.4), 5e-5, 5e-3);
    const double brightness = std::min(1.0, kFullTurn / (contactTime * kSampleRate));
    addNoise(buffer, start, 2.0 * contactTime, brightness, 0.5 * amplitude, random);
    for (const SoundMaterial material : {recipe.first, recipe.second}) {
        for (SoundMode mode : modesOf(material, mass, contactTime)) {
            mode.frequency *= random.between(0.97, 1.03);
            mode.amplitude *= amplitude * random.between(0.7, 1.0);
            if (mode.amplitude > 0.0) addMode(buffer, start, mode);
        }
    }
}

/// Adds cracks at random times, each of a fragment of the body.
void addCracks(Buffer& buffer, const SoundRecipe& recipe, int count, double within, double amplitude, Random& random) {
    for (int crack = 0; crack < count; ++crack) {
        const double part = random.unit();
        const std::size_t start = samplesOf(within * part * part);  // most of them early
        const double mass = recipe.mass * random.between(0.01, 0.2);
        addBlow(buffer, start, recipe, mass, amplitude * random.between(0.2, 1.0) * (1.0 - 0.7 * part), random);
    }
}

/// The samples up to the last audible one, scaled to the peak 1, faded out at the end.
std::vector<float> normalized(const Buffer& buffer) {
    double peak = 0.0;
    for (const double value : buffer) peak = std::max(peak, std::abs(value));
    if (peak == 0.0) return {};
    std::size_t length = buffer.size();
    while (length > 0 && std::abs(buffer[length - 1]) < kInaudible * peak) --length;
    std::vector<float> samples(length);
    constexpr std::size_t kFade = 240;  // 5 ms
    for (std::size_t k = 0; k < length; ++k) {
        const double fade = std::min(1.0, static_cast<double>(length - k) / kFade);
        samples[k] = static_cast<float>(buffer[k] / peak * fade);
    }
    return samples;
}

}  // namespace

std::array<SoundMode, kSoundModes> modesOf(SoundMaterial material, double mass, double contactTime) {
    // lambda = 2 pi f l² sqrt(12 (1 - nu²) density / E) / h of a loose square plate, for nu = 0.3.
    constexpr std::array<double, kSoundModes> kLambdas{13.5, 19.8, 24.4, 35.0, 35.0, 61.5, 61.5, 63.7, 69.3, 77.2};
    constexpr double kStiffening = 3.3045;  // sqrt(12 (1 - nu²))
    const SoundProperties& properties = propertiesOf(material);
    const double length = cubeRoot(mass / (properties.density * properties.slenderness));  // of a square plate
    const double speed = std::sqrt(properties.youngsModulus / properties.density);
    const double perLambda = properties.slenderness * speed / (length * kFullTurn * kStiffening);
    std::array<SoundMode, kSoundModes> modes;
    for (std::size_t k = 0; k < modes.size(); ++k) {
        const double frequency = std::max(perLambda * kLambdas[k], kLowest);
        // A blow of a half sine excites frequencies beyond the inverse of its length less and less.
        const double bandwidth = frequency * contactTime;
        modes[k] = {.frequency = frequency,
                    .decay = std::clamp(2.0 / (kFullTurn * frequency * properties.lossFactor), 0.002, 0.2),
                    .amplitude = frequency > kHighest
                                     ? 0.0
                                     : 1.0 / ((1.0 + 0.2 * static_cast<double>(k)) * (1.0 + bandwidth * bandwidth))};
    }
    return modes;
}

std::vector<float> synthesized(const SoundRecipe& recipe) {
    Random random(recipe.randomSeed);
    Buffer buffer(samplesOf(kLongest), 0.0);
    switch (recipe.kind) {
        case CueKind::Impact: addBlow(buffer, 0, recipe, recipe.mass, 1.0, random); break;
        case CueKind::Broken: {
            const double brightness = std::min(1.0, 0.2e-3 / propertiesOf(recipe.first).contactTime);
            addBlow(buffer, 0, recipe, recipe.mass, 1.0, random);
            addNoise(buffer, 0, 0.03, brightness, 1.0, random);
            addCracks(buffer, recipe, 16, 0.5, 0.6, random);
            break;
        }
    }
    return normalized(buffer);
}

}  // namespace rubble
