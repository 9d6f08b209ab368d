#include "viewport/scene/play/DustParticles.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kFadeIn = 0.04;            // s, of dust
constexpr double kDrag = 2.2;               // 1/s, air drag
constexpr double kLargestPhase = 0.999999;  // below 1 as a float, too

bool isDust(const ParticleStart& start) { return start.kind == ParticleKind::Dust; }

Vec3 positionAt(const ParticleStart& start, double age, const ParticleWorld& world) {
    Vec3 position = start.from + start.velocity * (age / (1.0 + kDrag * age));
    if (isDust(start) || start.kind == ParticleKind::Flash) return position;
    position += 0.5 * age * age * world.gravity;
    position.y = std::max(position.y, std::min(world.ground + start.radius, start.from.y));
    return position;
}

double radiusAt(const ParticleStart& start, double age) {
    return isDust(start) ? start.radius * (1.0 + 2.0 * age / (0.25 + age)) : start.radius;
}

double opacityAt(const ParticleStart& start, double age) {
    const double left = 1.0 - age / start.lifetime;
    switch (start.kind) {
        case ParticleKind::Dust: return start.opacity * std::min(1.0, age / kFadeIn) * left * left;
        case ParticleKind::Splinter:
        case ParticleKind::Chip: return start.opacity * std::min(1.0, 4.0 * left);
        case ParticleKind::Spark:
        case ParticleKind::Flash: return start.opacity * left;
    }
    return 0.0;
}

double phaseAt(const ParticleStart& start, double age) {
    const double phase = start.phase + start.spin * age;
    return std::min(phase - std::floor(phase), kLargestPhase);
}

}  // namespace

Particle particleAt(const ParticleStart& start, double age, const ParticleWorld& world) {
    const Vec3 now = positionAt(start, age, world);
    const Vec3 before = positionAt(start, std::max(0.0, age - world.stepLength), world);
    const double kind = static_cast<double>(start.kind);
    return {glm::vec4(glm::vec3(now - world.origin), radiusAt(start, age)),
            glm::vec4(glm::vec3(before - now), opacityAt(start, age)),
            glm::vec4(start.colour, kind + phaseAt(start, age))};
}

}  // namespace rubble
