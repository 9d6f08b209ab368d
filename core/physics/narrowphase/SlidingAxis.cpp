#include "core/physics/narrowphase/SlidingAxis.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr float kPredictedDepth = 0.0001f;  // m: overlap that counts as a collision
// Overlap of resting bodies, at most a tenth of their width: these touch, and slide along each other.
constexpr float kRestingDepth = 0.002f;  // m
constexpr float kRestingFraction = 0.1f;

float predicted(const SeparatingAxis& axis, Vec3f displacement) {
    return axis.separation + dot(axis.normal, displacement);
}

}  // namespace

std::optional<SeparatingAxis> slidingAxis(const SeparatingAxis& axis, const Hull& first, const Hull& second,
                                          const RelativePose& pose, Vec3f displacement) {
    if (predicted(axis, displacement) >= -kPredictedDepth) return std::nullopt;
    const float depth = std::min(kRestingDepth, kRestingFraction * std::min(first.minWidth, second.minWidth));
    std::optional<SeparatingAxis> best;
    const auto consider = [&](AxisKind kind, std::size_t count) {
        for (std::size_t face = 0; face < count; ++face) {
            const auto index = static_cast<std::uint16_t>(face);
            const SeparatingAxis found = faceAxis({.kind = kind, .first = index, .second = index}, first, second, pose);
            if (std::min(found.separation, predicted(found, displacement)) < -depth) continue;
            if (!best || predicted(found, displacement) > predicted(*best, displacement)) best = found;
        }
    };
    consider(AxisKind::FirstFace, first.planes.size());
    consider(AxisKind::SecondFace, second.planes.size());
    return best;
}

}  // namespace rubble
