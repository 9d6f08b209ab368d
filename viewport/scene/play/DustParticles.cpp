#include "viewport/scene/play/DustParticles.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kFadeIn = 0.04, kSlowFadeIn = 0.35;  // s, of dust
constexpr double kDrag = 2.2, kSlowDrag = 0.9;        // 1/s, air drag; of dust that lingers
constexpr double kSinking = 1.4;                      // s, after which such dust is half as high
constexpr double kLowest = 0.6;                       // of its first radius, over the ground
constexpr double kLargestSeed = 0.999999;             // below 1 as a float, too
constexpr double kNoGround = 1e9;                     // m, a depth below all

bool isDust(const ParticleStart& start) { return start.kind == ParticleKind::Dust; }

Vec3 positionAt(const ParticleStart& start, double age, const ParticleWorld& world) {
    const double drag = start.isLingering ? kSlowDrag : kDrag;
    Vec3 position = start.from + start.velocity * (age / (1.0 + drag * age));
    if (start.isLingering) {
        const double lowest = std::min(world.ground + kLowest * start.radius, start.from.y), part = age / kSinking;
        position.y = lowest + std::max(position.y - lowest, 0.0) / (1.0 + part * part);
    }
    if (isDust(start) || start.kind == ParticleKind::Flash) return position;
    position += 0.5 * age * age * world.gravity;
    position.y = std::max(position.y, std::min(world.ground + start.radius, start.from.y));
    return position;
}

double radiusAt(const ParticleStart& start, double age) {
    if (start.isLingering) return start.radius * (1.0 + 3.0 * age / (1.0 + age));
    return isDust(start) ? start.radius * (1.0 + 2.0 * age / (0.25 + age)) : start.radius;
}

double opacityAt(const ParticleStart& start, double age) {
    const double left = 1.0 - age / start.lifetime;
    switch (start.kind) {
        case ParticleKind::Dust: {
            const double fadeIn = start.isLingering ? kSlowFadeIn : kFadeIn;
            return start.opacity * std::min(1.0, age / fadeIn) * left * left;
        }
        case ParticleKind::Spark:
        case ParticleKind::Flash: return start.opacity * left;
    }
    return 0.0;
}

}  // namespace

ParticleWorld particleWorldOf(const RenderScene& scene, const DustMoment& moment) {
    return {.gravity = moment.gravity,
            .ground = scene.hasGround ? scene.groundHeight : -kNoGround,
            .origin = scene.origin,
            .stepLength = moment.stepLength};
}

Particle particleAt(const ParticleStart& start, double age, const ParticleWorld& world) {
    const Vec3 now = positionAt(start, age, world);
    const Vec3 before = positionAt(start, std::max(0.0, age - world.stepLength), world);
    const double kind = static_cast<double>(start.kind);
    return {glm::vec4(glm::vec3(now - world.origin), radiusAt(start, age)),
            glm::vec4(glm::vec3(before - now), opacityAt(start, age)),
            glm::vec4(start.colour, kind + std::min(start.seed, kLargestSeed))};
}

}  // namespace rubble
