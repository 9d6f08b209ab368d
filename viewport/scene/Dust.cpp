#include "viewport/scene/Dust.h"

#include "core/base/Random.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace rubble {
namespace {

constexpr int kPuffs = 14;                 // per break
constexpr std::size_t kMaxPuffs = 1200;    // per scene, latest breaks first: more would only overlap
constexpr double kLifetime = 0.8;          // s
constexpr double kFadeIn = 0.04;           // s
constexpr double kOpacity = 0.75;          // after the fade-in
constexpr double kDrag = 2.2;              // 1/s, air drag
constexpr Colour kPale{0.90, 0.88, 0.85};  // most of any dust's colour
constexpr double kPaleFraction = 0.7;
constexpr std::uint64_t kStream = 0xd057;

/// A puff at its start. Lengths are relative to the size of the broken body.
struct Puff {
    Vec3 from;
    Vec3 velocity;
    double radius = 0.0;
    double lifetime = 0.0;  // s
    double seed = 0.0;      // of its noise

    Vec3 positionAt(double age) const { return from + velocity * (age / (1.0 + kDrag * age)); }
    double radiusAt(double age) const { return radius * (1.0 + 2.6 * age / (0.3 + age)); }
    double opacityAt(double age) const {
        const double left = 1.0 - age / lifetime;
        return kOpacity * std::min(1.0, age / kFadeIn) * left * left;
    }
};

/// A point of a random cut between two pieces of a broken body, in the frame of its asset.
Vec3 cutAt(const PlayBreak& broken, const PlayFracture& fracture, Random& random) {
    if (fracture.neighbours.empty()) return broken.asset->pieces[fracture.first + random.below(fracture.count)].offset;
    const PlayContact& parted = fracture.neighbours[random.below(fracture.neighbours.size())];
    return 0.5 * (broken.asset->pieces[parted.first].offset + broken.asset->pieces[parted.second].offset);
}

/// Twice the largest distance of its pieces from its centre.
double sizeOf(const PlayBreak& broken, const PlayFracture& fracture, Vec3 centre) {
    double size = 0.0;
    for (std::uint32_t k = 0; k < fracture.count; ++k) {
        size = std::max(size, glm::distance(broken.asset->pieces[fracture.first + k].offset, centre));
    }
    return 2.0 * size;
}

Puff puffOf(const PlayBreak& broken, const PlayFracture& fracture, Random& random) {
    const Vec3 centre = broken.asset->piece(broken.body.fragment).offset;
    const double size = sizeOf(broken, fracture, centre);
    const Vec3 from = broken.pose.position + broken.pose.orientation * (cutAt(broken, fracture, random) - centre);
    const Vec3 arm = from - broken.point;
    const Vec3 away = glm::dot(arm, arm) > 1e-12 ? glm::normalize(arm) : broken.normal;
    const Vec3 onwards = random.between(-0.9, 0.9) * broken.normal, up(0.0, random.between(0.1, 0.7), 0.0);
    return {.from = from,
            .velocity = size * (random.between(0.4, 1.6) * away + onwards + up),
            .radius = size * random.between(0.22, 0.42),
            .lifetime = kLifetime * random.between(0.65, 1.1),
            .seed = random.unit()};
}

glm::vec3 colourOf(const PlayBreak& broken, const Project& project) {
    const AssetMaterials material = materialsOf(project, *findAsset(project, broken.asset->bake->asset));
    const Colour& colour = material.inside.inside;
    const Vec3 inside(colour.red, colour.green, colour.blue);
    return glm::vec3(glm::mix(inside, Vec3(kPale.red, kPale.green, kPale.blue), kPaleFraction));
}

}  // namespace

void addDust(RenderScene& scene, const Session& session) {
    const std::vector<PlayBreak>& breaks = session.recentBreaks();
    const double dt = session.stepLength();
    for (auto broken = breaks.rbegin(); broken != breaks.rend() && scene.puffs.size() < kMaxPuffs; ++broken) {
        const double age = dt * static_cast<double>(session.stepsDone() + 1 - broken->step);
        const PlayFracture& fracture = *broken->asset->fractureOf(broken->body.fragment);
        const glm::vec3 colour = colourOf(*broken, session.scene().project);
        Random random(mixSeeds(broken->body.number, kStream));
        for (int k = 0; k < kPuffs; ++k) {
            const Puff puff = puffOf(*broken, fracture, random);
            if (age >= puff.lifetime) continue;
            const Vec3 position = puff.positionAt(age), previous = puff.positionAt(age - dt);
            scene.puffs.push_back({glm::vec4(glm::vec3(position - scene.origin), puff.radiusAt(age)),
                                   glm::vec4(glm::vec3(previous - position), puff.opacityAt(age)),
                                   glm::vec4(colour, puff.seed)});
        }
    }
}

}  // namespace rubble
