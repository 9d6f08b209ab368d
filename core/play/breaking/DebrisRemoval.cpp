#include "core/play/breaking/DebrisRemoval.h"

#include "core/base/MessageText.h"
#include "core/play/state/SessionBodies.h"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>

namespace rubble {
namespace {

constexpr double kWorldRadius = 2000.0;  // m: bodies beyond it are removed

/// Why a body cannot stay in the world, as the end of a sentence; nothing if it can.
std::optional<std::string> reasonToLeave(const SessionParts& parts, const PlayBody& body) {
    if (body.role == PlayRole::Ground) return std::nullopt;
    if (!parts.world().isWithinBounds(body.body)) return "its motion is beyond all bounds";
    const Vec3 position = parts.world().centre(body.body);
    if (!(glm::dot(position, position) < kWorldRadius * kWorldRadius)) {
        return "it is farther than " + messageText(kWorldRadius) + " m from the origin";
    }
    if (!(position.y > parts.state().lowest)) return "it fell below " + roundedText(parts.state().lowest, 6) + " m";
    return std::nullopt;
}

void reportLeft(SessionParts& parts, const PlayBody& body, const std::string& reason) {
    parts.state().events.diagnostics.push_back(
        diagnostic(DiagnosticCode::LeftWorld, placeOf(body),
                   quotedName(nameOf(body, parts.state().origins[body.origin])) + " was removed at step " +
                       std::to_string(parts.state().step) + ": " + reason + "."));
}

/// A body that is to be removed.
struct PendingRemoval {
    std::uint32_t number = 0;
    RemovalReason reason = RemovalReason::None;
};

/// Adds the debris that exceeds a number of fragments: sleeping first, then the smallest, then the oldest. Returns the
/// number of bodies visited.
std::size_t addExcess(const SessionParts& parts, std::uint32_t maxFragments, std::vector<PendingRemoval>& gone) {
    std::vector<std::tuple<bool, double, std::uint32_t>> debris;  // awake, volume, number
    for (const PlayBody& body : parts.state().bodies) {
        if (!body.isDebris() || std::ranges::binary_search(gone, body.number, {}, &PendingRemoval::number)) continue;
        debris.emplace_back(!parts.world().state(body.body).asleep, parts.world().shape(body.body).mass.volume,
                            body.number);
    }
    if (debris.size() <= maxFragments) return parts.state().bodies.size();
    const auto end = debris.begin() + static_cast<std::ptrdiff_t>(debris.size() - maxFragments);
    std::ranges::nth_element(debris, end);
    for (auto body = debris.begin(); body != end; ++body) gone.push_back({std::get<2>(*body), RemovalReason::Budget});
    return parts.state().bodies.size();
}

}  // namespace

double fadeOf(const PlayBody& body, const Debris& debris, std::uint64_t step, double dt) {
    if (!debris.lifetime || !body.isDebris()) return 0.0;
    const double left = *debris.lifetime - static_cast<double>(step - body.born) * dt;
    if (left <= 0.0) return 1.0;
    const double fade = std::min(debris.fade, *debris.lifetime);
    return left >= fade ? 0.0 : 1.0 - left / fade;
}

std::size_t removeDebris(SessionParts& parts) {
    const Debris& debris = parts.scene().project.debris;
    std::vector<PendingRemoval> gone;  // ascending numbers, then those in excess
    std::size_t visited = parts.state().bodies.size();
    for (const PlayBody& body : parts.state().bodies) {
        const bool isFaded = fadeOf(body, debris, parts.state().step, parts.settings().dt) >= 1.0;
        const std::optional<std::string> reason = isFaded ? std::nullopt : reasonToLeave(parts, body);
        if (reason) reportLeft(parts, body, *reason);
        if (isFaded) gone.push_back({body.number, RemovalReason::Lifetime});
        if (reason) gone.push_back({body.number, RemovalReason::LeftWorld});
    }
    if (debris.maxFragments) visited += addExcess(parts, *debris.maxFragments, gone);
    std::ranges::sort(gone, {}, &PendingRemoval::number);
    for (const auto& [number, reason] : gone) {
        parts.state().events.removed.push_back(removalOf(parts, *findBody(parts.state(), number), reason));
        removeFromWorld(parts, number);
        ++visited;
    }
    if (!gone.empty()) visited += eraseRemovedBodies(parts.state());
    return visited;
}

}  // namespace rubble
