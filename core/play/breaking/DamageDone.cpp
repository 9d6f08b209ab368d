#include "core/play/breaking/DamageDone.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

double momentumOf(const World& world, BodyId body) {
    const Vec3 velocity = world.state(body).velocity;
    return world.mass(body) * std::sqrt(glm::dot(velocity, velocity));
}

double damageTo(BodyId body, BodyId other, const Impact& impact, const World& world, DamageRule rule) {
    if (rule == DamageRule::Impact) return impact.impulse();
    return std::max(momentumOf(world, body) * (1.0 - world.restitution(body)), momentumOf(world, other));
}

}  // namespace

std::vector<DamageDone> damageOf(std::span<const Impact> impacts, const World& world, DamageRule rule) {
    std::vector<DamageDone> damage;
    for (std::uint32_t k = 0; k < impacts.size(); ++k) {
        const Impact& impact = impacts[k];
        damage.push_back({impact.first, damageTo(impact.first, impact.second, impact, world, rule), k});
        damage.push_back({impact.second, damageTo(impact.second, impact.first, impact, world, rule), k});
    }
    std::ranges::sort(damage, [](const DamageDone& a, const DamageDone& b) {
        if (a.body != b.body) return a.body < b.body;
        return a.amount != b.amount ? a.amount > b.amount : a.impact < b.impact;
    });
    const auto isSame = [](const DamageDone& a, const DamageDone& b) { return a.body == b.body; };
    damage.erase(std::unique(damage.begin(), damage.end(), isSame), damage.end());
    return damage;
}

}  // namespace rubble
