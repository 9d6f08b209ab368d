#include "core/play/breaking/HitIntervals.h"

#include "core/play/breaking/BondBreaking.h"
#include "core/play/breaking/DamageDone.h"
#include "core/play/state/SessionBodies.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kCertain = 0.75;  // of what breaks: a weaker impact breaks nothing in any interval

/// The smallest damage that breaks a body or damages one of its bonds, N·s.
double leastDamage(const SessionParts& parts, const PlayBody& body) {
    return body.bondedFracture() != nullptr ? knownStructure(parts, body)->leastImpulse
                                            : thresholdOf(parts.state(), parts.scene(), body);
}

}  // namespace

int hitIntervals(double dt) {
    constexpr double kRounding = 1e-6;  // of an interval
    return std::max(1, static_cast<int>(std::ceil(dt / kHitInterval - kRounding)));
}

bool mayBreak(const SessionParts& parts, std::span<const Impact> impacts) {
    if (!parts.state().hasDestruction) return false;
    const auto breaks = [&](const DamageDone& damage) {
        const PlayBody* const body =
            findBody(parts.state(), static_cast<std::uint32_t>(parts.world().tag(damage.body)));
        if (body->fracture() == nullptr && body->bondedFracture() == nullptr) return false;
        return damage.amount >= kCertain * leastDamage(parts, *body);
    };
    return std::ranges::any_of(damageOf(impacts, parts.world(), parts.scene().project.damage.rule), breaks);
}

}  // namespace rubble
