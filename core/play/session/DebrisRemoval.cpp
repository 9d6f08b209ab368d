#include "core/play/session/DebrisRemoval.h"

#include "core/play/state/SessionBodies.h"

#include <algorithm>
#include <tuple>

namespace rubble {
namespace {

constexpr double kWorldRadius = 2000.0;  // m: bodies beyond it are removed

bool hasLeftTheWorld(const SessionParts& parts, const PlayBody& body) {
    if (body.role == PlayRole::Ground) return false;
    const Vec3 position = parts.world.state(body.body).centre;
    return !(position.y > parts.state.lowest &&
             glm::dot(position, position) < kWorldRadius * kWorldRadius);  // also for NaN
}

/// Adds the debris that exceeds a number of pieces: sleeping first, then the smallest, then the oldest. Returns the
/// number of bodies visited.
std::size_t addExcess(const SessionParts& parts, std::uint32_t maxPieces, std::vector<std::uint32_t>& gone) {
    std::vector<std::tuple<bool, double, std::uint32_t>> debris;  // awake, volume, number
    for (const PlayBody& body : parts.state.bodies) {
        if (!body.isDebris() || std::ranges::binary_search(gone, body.number)) continue;
        debris.emplace_back(!parts.world.state(body.body).asleep, parts.world.shape(body.body).mass.volume,
                            body.number);
    }
    if (debris.size() <= maxPieces) return parts.state.bodies.size();
    const auto end = debris.begin() + static_cast<std::ptrdiff_t>(debris.size() - maxPieces);
    std::ranges::nth_element(debris, end);
    for (auto one = debris.begin(); one != end; ++one) gone.push_back(std::get<2>(*one));
    return parts.state.bodies.size();
}

}  // namespace

double fadeOf(const PlayBody& body, const Debris& debris, std::uint64_t step, double dt) {
    if (!debris.lifetime || !body.isDebris()) return 0.0;
    const double left = *debris.lifetime - static_cast<double>(step - body.born) * dt;
    const double fade = std::min(debris.fade, *debris.lifetime);
    if (left >= fade) return 0.0;
    return left <= 0.0 ? 1.0 : 1.0 - left / fade;
}

std::size_t removeDebris(const SessionParts& parts) {
    const Debris& debris = parts.scene.project.debris;
    std::vector<std::uint32_t> gone;
    std::size_t visited = parts.state.bodies.size();
    for (const PlayBody& body : parts.state.bodies) {
        const bool isFaded = fadeOf(body, debris, parts.state.step, parts.settings.dt) >= 1.0;
        if (isFaded || hasLeftTheWorld(parts, body)) gone.push_back(body.number);
    }
    if (debris.maxPieces) visited += addExcess(parts, *debris.maxPieces, gone);
    std::ranges::sort(gone);
    for (const std::uint32_t number : gone) {
        parts.state.events.removed.push_back(*findBody(parts.state, number));
        removeFromWorld(parts, number);
        ++visited;
    }
    if (!gone.empty()) visited += eraseRemovedBodies(parts.state);
    return visited;
}

}  // namespace rubble
