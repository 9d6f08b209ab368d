#include "core/sound/mix/SoundCue.h"

#include "core/base/math/Trigonometry.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kAmplitudeOfJoule = 0.02;  // of full scale, 1 m away: 2.5 kJ reach it
constexpr double kNearest = 1.0;            // m: what is nearer is as loud
constexpr std::uint64_t kTakes = 4;         // samples of the same kind that follow each other

bool isFinite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

std::optional<std::string> faultOf(const SoundCue& cue) {
    if (!(cue.time >= 0.0 && cue.time <= kMaxTrackSeconds)) return "its time is not within the longest track";
    if (!(cue.energy >= 0.0 && std::isfinite(cue.energy))) return "its energy is negative or not finite";
    if (!(cue.mass > 0.0 && std::isfinite(cue.mass))) return "its mass is not positive and finite";
    if (!isFinite(cue.point)) return "its point is not finite";
    return std::nullopt;
}

std::array<double, 2> levelsOf(const SoundCue& cue, const Listener& listener) {
    const Vec3 way = cue.point - listener.position;
    const double distance = glm::length(way);
    const double level = kAmplitudeOfJoule * std::sqrt(cue.energy) / std::max(kNearest, distance);
    const double pan = distance > 0.0 ? std::clamp(glm::dot(way, listener.right) / distance, -1.0, 1.0) : 0.0;
    const double angle = (1.0 + pan) * kFullTurn / 8.0;
    return {level * cosine(angle), level * sine(angle)};
}

SharedSample sampleOf(const SoundCue& cue, std::uint64_t index, SampleCache& cache) {
    return cache.sampleOf({.kind = cue.kind, .first = cue.first, .second = cue.second, .mass = cue.mass},
                          index % kTakes);
}

}  // namespace rubble
