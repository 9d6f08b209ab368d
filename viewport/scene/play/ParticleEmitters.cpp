#include "viewport/scene/play/ParticleEmitters.h"

#include "core/base/math/Roots.h"
#include "core/base/math/Trigonometry.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kMaxSize = 1.0;  // m: what breaks off a larger body makes no larger clouds

}  // namespace

Random randomOf(const EventRecord& event, std::uint64_t stream) {
    return Random(mixSeeds(mixSeeds(stream + static_cast<std::uint64_t>(event.kind), event.step),
                           mixSeeds(event.body, event.other)));
}

Vec3 randomDirection(Random& random) {
    const double height = random.between(-1.0, 1.0), angle = random.between(0.0, kFullTurn);
    const double radius = std::sqrt(1.0 - height * height);
    return {radius * cosine(angle), height, radius * sine(angle)};
}

double scaledByEnergy(double energy, double one, double least, double most) {
    constexpr double kLeast = 1e-9;  // J: the root is of positive numbers only
    return std::clamp(one * cubeRoot(std::max(energy, kLeast)), least, most);
}

BreakEmitter::BreakEmitter(const EventRecord& broken, double density)
    : m_broken(broken),
      m_extent(broken.box.max - broken.box.min),
      m_largest(std::max({m_extent.x, m_extent.y, m_extent.z})),
      m_size(std::min(m_largest, kMaxSize)) {
    const Vec3 across = glm::abs(broken.normal);
    const double shown = across.x * m_extent.y * m_extent.z + across.y * m_extent.z * m_extent.x +
                         across.z * m_extent.x * m_extent.y;  // m²: the box, seen along the normal
    if (shown > 0.0) m_thickness = std::min(broken.mass / density / shown, glm::dot(across, m_extent));
}

EmittedStart BreakEmitter::next(Random& random) const {
    const Vec3 place = m_broken.box.min + Vec3(random.unit(), random.unit(), random.unit()) * m_extent;
    Vec3 from = glm::mix(m_broken.point, place, random.unit());  // denser near the point
    const bool isOpposite = random.unit() < 0.5;
    const bool isHit = m_broken.normal != Vec3(0.0);
    Vec3 out = isHit ? m_broken.normal : randomDirection(random);
    if (!isOpposite) out = -out;
    if (isHit) {
        from -= glm::dot(from - m_broken.point, m_broken.normal) * m_broken.normal;
        if (isOpposite) from += m_thickness * m_broken.normal;
    }
    const Vec3 arm = from - m_broken.point;
    const Vec3 away = glm::dot(arm, arm) > 1e-12 ? glm::normalize(arm) : out;
    const Vec3 up(0.0, random.between(0.1, 0.7), 0.0);
    return {from, m_size * (random.between(0.2, 1.2) * away + random.between(0.2, 1.2) * out + up)};
}

ImpactEmitter::ImpactEmitter(const EventRecord& impact)
    : m_impact(impact), m_speed(scaledByEnergy(impact.energy, 0.3, 0.3, 3.0)) {}

EmittedStart ImpactEmitter::next(Random& random) const {
    const Vec3 direction = randomDirection(random);
    const Vec3 along = direction - glm::dot(direction, m_impact.normal) * m_impact.normal;
    const Vec3 up(0.0, random.between(0.0, 0.3), 0.0);
    return {m_impact.point, m_speed * (random.between(0.3, 1.0) * along + 0.3 * direction + up)};
}

}  // namespace rubble
